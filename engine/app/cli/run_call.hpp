#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "engine/app/cli/model_call.hpp"
#include "engine/app/session/fitting.hpp"
#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/signal_files.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/session/tuning.hpp"
#include "engine/base/junit/junit.hpp"
#include "engine/simulate/device/gpu_runs.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::cli {

/// Call of `run`, `fit`, `tune` or `study`.
struct RunCall {
  ModelCall models;
  std::string out;       ///< Folder; empty: no files; "-": archive on the standard output.
  bool archive = false;  ///< True: `out` is the folder of an archive, with a subfolder for each file.
  std::string csv;       ///< File for the recorded table; "-": standard output; empty: none.
  std::optional<session::FileKinds> files{};
  render::PictureKinds pictures = render::usual_pictures;
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  device::DeviceUse device = device::DeviceUse::cpu;  ///< of the points of a sweep
  bool profile = false;                               ///< measure the cost of each block
  bool coverage = false;                              ///< find the branches of conditions that the runs take
  std::string requires_section;                       ///< section that each file must have; empty: none
  session::FitCall fit;
  session::TuneCall tune;
  std::optional<session::Share> part;  ///< share of a sweep that this call runs
  std::string junit;                   ///< File for the claims as test cases; empty: none.
  std::shared_ptr<std::vector<junit::TestSuite>> suites{};  ///< Suites of the files; nullptr without `junit`.
  bool mpi = false;  ///< distribute the work of the one file to the processes of mpirun
};

inline constexpr const char* standard_output = "-";

/// Declares the common options of the four verbs; `out` is the help text of --out.
void add_run_options(CLI::App& verb, RunCall& call, const std::string& out);

void add_kinds_options(CLI::App& verb, std::optional<session::FileKinds>& files,
                       render::PictureKinds& pictures);

/// Runs the files. A file with a fit is fitted first; for a file with a study the trials are run.
ExitCode run_models(const RunCall& call, const Registry& registry);

}  // namespace stepwire::cli
