#pragma once

#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"
#include "engine/app/session/signal_files.hpp"
#include "engine/base/json/json.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::session {

/// Writes all that a run leaves behind into a folder: its signals and pictures as files of these kinds, with
/// the pictures' specs (figure.svg, figure.json), claims.json, run.json. Each file appears whole or not at
/// all. Returns the names of the pictures. Throws EnvironmentError.
std::vector<std::string> write_outputs(const std::string& folder, const LoadedModel& model,
                                       const Outcome& outcome, const FileKinds& kinds = usual_files,
                                       const render::PictureKinds& drawn = render::usual_pictures);

/// The verdicts as a list of {file, figure, that, check, value, holds, disagrees?, note?}.
json::Json claims_json(const LoadedModel& model, const Outcome& outcome);
/// What algebraic loops have cost, as a list of {loop, unknowns, instants, iterations, max_iterations,
/// unsolved, first_unsolved}.
json::Json algebraic_loops_json(const std::vector<run::LoopCost>& loops);
/// What was run: hash of the flattened diagram, parameters, step, solver, version, compiler, duration.
json::Json run_json(const LoadedModel& model, const Outcome& outcome);

}  // namespace stepwire::session
