#pragma once

#include "engine/app/cli/mpi_run.hpp"
#include "engine/app/cli/run_call.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::cli {

/// The folder for the results of a file: several files get one each, and those of an archive; empty where
/// nothing is written.
std::string folder_of(const RunCall& call, const std::string& file);

/// Does with a loaded model what the call is for: fits it, runs it or its study, prints and writes the
/// results, and pushes those for programs to the list. `session` is what the files of one call share; `mpi`
/// may be null.
ExitCode run_file(const RunCall& call, session::Session& session, session::LoadedModel& model,
                  json::Json& results, MpiRun* mpi);

/// Prints what a run came to; of a quiet call what failed.
void put_outcome(const session::LoadedModel& model, const session::Outcome& outcome);

}  // namespace stepwire::cli
