#pragma once

#include "engine/app/studio/live/loaded_run.hpp"

namespace stepwire::live {

/// What `run.load` answers: columns, parameters, scopes, inputs, and what else the file has to show.
json::Json run_description(LoadedRun& run);

}  // namespace stepwire::live
