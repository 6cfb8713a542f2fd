#pragma once

#include <memory>
#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/signal_files.hpp"
#include "engine/base/io/owned_folder.hpp"

namespace stepwire::session {

/// The folder of a model's results, from now on this run's alone; results of earlier runs are removed from
/// it. What the model itself reads may lie there, and experiments that took hours stay for the call that goes
/// on with them. Throws EnvironmentError where another run owns the folder or where it holds files with the
/// names of results that no run wrote: before the run, not behind it. Null for an empty name.
std::unique_ptr<io::OwnedFolder> own_results(const std::string& folder, const LoadedModel& model,
                                               const FileKinds& kinds = usual_files);

}  // namespace stepwire::session
