#pragma once

#include "engine/app/studio/live/loaded_run.hpp"

namespace stepwire::live {

/// Returns the answer to `run.load`: columns, parameters, scopes, inputs, and other features of the file.
json::Json run_description(LoadedRun& run);

}  // namespace stepwire::live
