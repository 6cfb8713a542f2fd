#pragma once

#include <vector>

#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/request.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::linear {

/// Returns the names of an analysis `loop` for figures and claims: loop.margin.gain, loop.pole.real, ...; all
/// in one recording.
std::vector<query::RecordedName> analysis_names(const NamedAnalysis& analysis, std::size_t recording);

/// Returns the analysis of one run as such a recording. Shorter lists (poles, zeros) are padded with their
/// last number. Numbers of the whole analysis are repeated in each row. Missing numbers are nan.
record::Recording analysis_recording(const NamedAnalysis& named, const Analysis& analysis);

}  // namespace stepwire::linear
