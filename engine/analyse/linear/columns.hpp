#pragma once

#include <vector>

#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/section.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::linear {

/// What figures and claims may name of an analysis called `loop`: loop.margin.gain, loop.pole.real, ...; all
/// in one recording.
std::vector<query::RecordedName> analysis_names(const NamedAnalysis& analysis, std::size_t recording);

/// The analysis of one run as such a recording. Lists that are shorter than others (poles, zeros) go on with
/// their last number; numbers of the whole analysis stand in each row. What there is none of is nan.
record::Recording analysis_recording(const NamedAnalysis& named, const Analysis& analysis);

}  // namespace stepwire::linear
