#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::cli {

/// A sweep whose points are kept in its folder while it goes on: a call that was interrupted or killed goes
/// on by the same words.
class KeptRun {
 public:
  /// Says what an earlier call has left. Throws EnvironmentError.
  KeptRun(const session::LoadedModel& model, const session::RowUse& use, const session::Share& share = {});

  /// Runs what is missing, on so many threads (0: all cores), and joins all.
  session::Outcome run(session::Session& session, run::ExecutionMode engine, unsigned threads = 0);
  /// Runs what is missing of a share, and says what is to be done with it.
  ExitCode run_share(session::Session& session, run::ExecutionMode engine, unsigned threads);
  /// The same for a share that was run meanwhile, as far as it was.
  ExitCode end_share();
  /// Has points run, by a function that says how, and joins all that is there. Files of runs are written
  /// meanwhile.
  session::Outcome joined(const std::function<session::PointsReport()>& run);
  session::KeptPoints& points() { return kept_; }
  /// Once the results are written: the points go.
  void drop();

 private:
  void note_interrupted();

  const session::LoadedModel& model_;
  const session::RowUse use_;
  const std::string folder_;
  const session::Share share_;
  session::KeptPoints kept_;
};

/// "2/3" as a share. Throws CLI::ValidationError.
session::Share share_of(const std::string& text);

}  // namespace stepwire::cli
