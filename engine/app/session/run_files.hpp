#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/app/session/signal_files.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::session {

/// Writes the results of a run into a folder: signals and pictures in the given formats, specifications of
/// the pictures (figure.json), claims.json and run.json.
/// Each file is written completely or not at all. Returns the names of the pictures. Throws EnvironmentError.
std::vector<std::string> write_outputs(const std::string& folder, const LoadedModel& model,
                                       const Outcome& outcome, const FileKinds& kinds = usual_files,
                                       const render::PictureKinds& drawn = render::usual_pictures);

/// Takes ownership of the folder of a model's results, and removes results of earlier runs. Inputs of the
/// model in the folder stay, and so do journals of experiments, which the next call continues.
/// Throws EnvironmentError, before the run, if another run owns the folder or if a foreign file has the name
/// of a result. Returns nullptr for an empty name.
std::unique_ptr<io::OwnedFolder> own_results(const std::string& folder, const LoadedModel& model,
                                             const FileKinds& kinds = usual_files);

}  // namespace stepwire::session
