#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/app/cli/model_call.hpp"
#include "engine/app/session/fitting.hpp"
#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/signal_files.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/session/tuning.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::cli {

/// A call of `run`, `fit`, `tune` or `study`.
struct RunCall {
  ModelCall models;
  std::string out;       ///< folder; empty: nothing is written; "-": an archive on the standard output
  bool archive = false;  ///< `out` holds what becomes an archive: a folder for each file
  std::string csv;       ///< file for the recorded table; "-": the standard output; empty: none
  std::optional<session::FileKinds> files{};
  render::PictureKinds pictures = render::usual_pictures;
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  bool profile = false;          ///< measure what each block costs
  std::string requires_section;  ///< a file without this section is refused; empty: any file will do
  session::FitCall fit;
  session::TuneCall tune;
  std::optional<session::Share> part;  ///< of a sweep: what this call runs
  bool mpi = false;                    ///< the processes of mpirun share the work of the one file
};

inline constexpr const char* standard_output = "-";

/// Declares the options that the four have; `out` explains --out.
void add_run_options(CLI::App& verb, RunCall& call, const std::string& out);

/// Declares --files and --pictures.
void add_kinds_options(CLI::App& verb, std::optional<session::FileKinds>& files,
                       render::PictureKinds& pictures);

/// Runs the files; one with a fit is fitted first, and of one with a study the trials are run.
ExitCode run_models(const RunCall& call, const Registry& registry);

}  // namespace stepwire::cli
