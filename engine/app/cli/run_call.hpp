#pragma once

#include <cstddef>
#include <string>

#include "engine/app/cli/model_call.hpp"
#include "engine/app/session/fitting.hpp"
#include "engine/app/session/signal_files.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/session/tuning.hpp"

namespace stepwire::cli {

/// A call of `run`, `fit`, `tune` or `study`.
struct RunCall {
  ModelCall models;
  std::string out;  ///< folder; empty: nothing is written
  session::FileKinds files = session::usual_files;
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  bool profile = false;          ///< measure what each block costs
  std::string requires_section;  ///< a file without this section is refused; empty: any file will do
  session::FitCall fit;
  session::TuneCall tune;
  unsigned study_threads = 0;  ///< 0: all cores
};

/// Declares the options that the four have; `out` explains --out.
void add_run_options(CLI::App& verb, RunCall& call, const std::string& out);

/// Runs the files; one with a fit is fitted first, and of one with a study the trials are run.
ExitCode run_models(const RunCall& call, const Registry& registry);

}  // namespace stepwire::cli
