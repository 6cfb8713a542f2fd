#pragma once

#include "engine/app/cli/mpi_run.hpp"
#include "engine/app/cli/run_call.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::cli {

/// Returns the folder for the results of a file; empty without --out. Several files, and the files of an
/// archive, get subfolders.
std::string folder_of(const RunCall& call, const std::string& file);

/// Performs the call on a loaded model: fits it, runs it or its study, and prints and writes the results.
/// Results for --json are pushed to the list. Files of one call share `session`. `mpi` may be nullptr.
ExitCode run_file(const RunCall& call, session::Session& session, session::LoadedModel& model,
                  json::Json& results, MpiRun* mpi);

/// Prints the outcome of a run; in a quiet call only its failures.
void put_outcome(const session::LoadedModel& model, const session::Outcome& outcome);

}  // namespace stepwire::cli
