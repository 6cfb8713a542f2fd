#pragma once

#include <span>
#include <vector>

#include "engine/analyse/claim/judge.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/simulate/run/point_exchange.hpp"

namespace stepwire::session {

/// What became of a file.
struct Outcome {
  run::RunResult result;
  std::vector<record::Recording>
      shown;  ///< the recordings with what the scene shows and linear analyses; empty without either
  std::vector<claim::Verdict> verdicts;
  double seconds = 0.0;  ///< of the run itself, without loading and drawing
  /// Were the runs looked at one by one? Then the files of signals are written, and the recordings have those
  /// rows alone that figures read.
  bool rows_passed = false;

  /// What figures and claims read.
  std::span<const record::Recording> recordings() const { return shown.empty() ? result.recordings : shown; }
  /// Did it end before its time, by a fault or an interruption?
  bool early() const { return !result.faults.empty() || result.interrupted; }
};

/// Adds what the scene shows and linear analyses to what figures and claims read.
void add_shown(const LoadedModel& model, Outcome& outcome);

/// What claims and the sensitivity of a model make of runs, which are added in pieces, in their order.
class RunJudges {
 public:
  /// The model must outlive it.
  explicit RunJudges(const LoadedModel& model);

  /// Adds runs with what the scene shows in them.
  void add(std::span<const record::Recording> runs);
  /// Adds what else claims read behind the recordings of all runs, and judges.
  void judge(Outcome& outcome);

 private:
  const LoadedModel& model_;
  std::size_t of_runs_;  ///< recordings
  std::vector<claim::Judge> judges_;
  sensitivity::RunOutcomes numbers_;
};

/// Judges all claims on what was recorded; those about a run that ended early do not hold.
void judge_claims(const LoadedModel& model, Outcome& outcome);

/// Judges the claims of the model, which may have been loaded with other figures, on the rows of an outcome.
void judge_again(const LoadedModel& model, Outcome& outcome);

/// Runs and judges. Claims about a run that ended early are not judged and do not hold.
Outcome run_model(const LoadedModel& model, const run::RunOptions& options);
/// The same, watched, on so many threads (0: all cores); `code` compiles what the engine does not interpret.
Outcome run_model(const LoadedModel& model, run::ExecutionMode engine, plan::CodeSource& code,
                  const Monitor& monitor, unsigned threads = 0);

/// How the points of an exchange were run.
struct PointsReport {
  double seconds = 0.0;
  run::LaneReport lanes{};
};

/// Runs the points of a model's sweep that an exchange names, on so many threads (0: all cores); what they
/// give is joined by the caller.
PointsReport run_points(const LoadedModel& model, run::ExecutionMode engine, plan::CodeSource& code,
                        const Monitor& monitor, run::PointExchange& exchange, unsigned threads = 0);

}  // namespace stepwire::session
