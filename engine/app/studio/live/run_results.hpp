#pragma once

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// Returns the figures of the file with the data and values so far, each in the format of figure.json. A
/// figure that cannot be drawn yet has `fault` in place of its panels.
json::Json figures_now(LoadedRun& run);

/// Returns the claims, each with a `verdict`: ok, FAIL, known or open. A known failure is listed in the file.
/// An open claim cannot be judged, or not before the end of the run. A claim that depends on a value set
/// during the run is open, with a note.
json::Json claims_now(LoadedRun& run);

/// Returns all samples of columns between two times as CSV, with units in the header.
std::string csv_of(LoadedRun& run, const std::vector<std::size_t>& columns, double from, double to);

/// Returns statistics of all samples of columns between two times.
json::Json statistics_of(LoadedRun& run, const std::vector<std::size_t>& columns, double from, double to);

}  // namespace stepwire::live
