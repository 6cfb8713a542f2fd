#pragma once

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// The figures of the file as they are by now, with the values that are set now, each as in figure.json; with
/// `fault` in the place of panels where there is nothing to draw yet.
json::Json figures_now(LoadedRun& run);

/// The claims with `verdict`: ok, FAIL, known (the file says so), open (the run has not ended, or nothing can
/// be said of it). A claim is about a run with one set of values: one that reads a value which was set on the
/// way is open, and says so.
json::Json claims_now(LoadedRun& run);

/// Columns between two times as CSV with units in the header, all samples.
std::string csv_of(LoadedRun& run, const std::vector<std::size_t>& columns, double from, double to);

/// For each column what all samples between two times say.
json::Json statistics_of(LoadedRun& run, const std::vector<std::size_t>& columns, double from, double to);

}  // namespace stepwire::live
