#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::cli {

/// Sweep with a journal in its folder. After an interruption or a kill, the same call continues it.
class KeptRun {
 public:
  /// Opens the journal and reports the points of an earlier call. Throws EnvironmentError.
  KeptRun(const session::LoadedModel& model, const session::RowUse& use, const session::Share& share = {});

  /// Runs the missing points on `threads` threads (0: all cores) and joins all points.
  session::Outcome run(session::Session& session, run::ExecutionMode engine, unsigned threads = 0);
  /// Runs the missing points of a share, and prints how to collect the shares.
  ExitCode run_share(session::Session& session, run::ExecutionMode engine, unsigned threads);
  /// Ends a share that was run elsewhere, like run_share().
  ExitCode end_share();
  /// Calls `run`, which runs the missing points, and joins all points. Files of runs are written meanwhile.
  session::Outcome joined(const std::function<session::PointsReport()>& run);
  session::KeptPoints& points() { return kept_; }
  /// Removes the journal, after the results are written.
  void drop();

 private:
  void note_interrupted();

  const session::LoadedModel& model_;
  const session::RowUse use_;
  const std::string folder_;
  const session::Share share_;
  session::KeptPoints kept_;
};

/// Parses a share such as "2/3". Throws CLI::ValidationError.
session::Share share_of(const std::string& text);

}  // namespace stepwire::cli
