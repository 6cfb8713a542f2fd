#pragma once

#include "engine/app/studio/live/loaded_run.hpp"

namespace stepwire::live {

/// Returns the independent parameters of a run and the numbers of its blocks; values that follow from other
/// parameters are omitted. Each has its value in SI and the unit in which its file writes it.
json::Json parameters_json(const LoadedRun& run);

}  // namespace stepwire::live
