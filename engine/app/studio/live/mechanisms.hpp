#pragma once

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// The mechanisms of a file, for pages that let them move: each `plot: rig`, or, without one, each block that
/// is a linkage. As in the JSON of a rig, but a coordinate is a number [m] or the expression of a signal.
json::Json mechanisms_of(const LoadedRun& run);

}  // namespace stepwire::live
