#pragma once

#include "engine/app/studio/live/loaded_run.hpp"

namespace stepwire::live {

/// The parameters of a run and the numbers of its blocks, each once: a value that follows from another
/// parameter is left out. Each has its value in SI and the unit in which its file writes it.
json::Json parameters_json(const LoadedRun& run);

}  // namespace stepwire::live
