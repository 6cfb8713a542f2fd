#pragma once

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// Returns the mechanisms of a file for animation: each `plot: rig`, or without one each linkage block. The
/// format is the JSON of a rig, but a coordinate is a number [m] or the expression of a signal.
json::Json mechanisms_of(const LoadedRun& run);

}  // namespace stepwire::live
