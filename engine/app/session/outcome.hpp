#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/judge.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/simulate/run/point_exchange.hpp"

namespace stepwire::session {

/// Results of running a file.
struct Outcome {
  run::RunResult result;
  std::vector<record::Recording>
      shown;  ///< recordings with scene states and linear analyses; empty without either
  std::vector<claim::Verdict> verdicts;
  double seconds = 0.0;  ///< duration of the run, without loading and drawing
  /// True if the runs were processed one by one. Then the files of signals are already written, and the
  /// recordings have only the rows that figures read.
  bool rows_passed = false;

  /// Recordings for figures and claims.
  std::span<const record::Recording> recordings() const { return shown.empty() ? result.recordings : shown; }
  /// True after a fault or an interruption.
  bool early() const { return !result.faults.empty() || result.interrupted; }
};

/// Appends scene states and linear analyses to the recordings for figures and claims.
void add_shown(const LoadedModel& model, Outcome& outcome);

/// Incremental judge of claims and sensitivity. Runs are added in order, in any grouping.
class RunJudges {
 public:
  /// The model must outlive the object.
  explicit RunJudges(const LoadedModel& model);

  /// Adds runs, with their scene states.
  void add(std::span<const record::Recording> runs);
  /// Adds the recordings that follow those of the runs, and judges.
  void judge(Outcome& outcome);

 private:
  const LoadedModel& model_;
  std::size_t of_runs_;  ///< number of recordings per run
  std::vector<claim::Judge> judges_;
  sensitivity::RunOutcomes numbers_;
};

/// Judges all claims. After an early end of a run they are not judged and do not hold.
void judge_claims(const LoadedModel& model, Outcome& outcome);

/// Judges the claims again on the rows of an outcome. The model may have been reloaded with other figures.
void judge_again(const LoadedModel& model, Outcome& outcome);

/// Runs the model and judges its claims. After an early end of a run they are not judged and do not hold.
Outcome run_model(const LoadedModel& model, const run::RunOptions& options);
/// Does the same with a monitor, on `threads` threads (0: all cores). `code` compiles the plan unless the
/// engine is the interpreter. A sweep is run on `device`, if it is not nullptr, as far as its plans allow it.
Outcome run_model(const LoadedModel& model, run::ExecutionMode engine, plan::CodeSource& code,
                  const Monitor& monitor, unsigned threads = 0, run::DeviceSource* device = nullptr);

/// Duration and lane use of a call of run_points().
struct PointsReport {
  double seconds = 0.0;
  run::LaneReport lanes{};
};

/// Runs the points that an exchange names, on `threads` threads (0: all cores), and on `device`. The exchange
/// gets the results, which the caller joins.
PointsReport run_points(const LoadedModel& model, run::ExecutionMode engine, plan::CodeSource& code,
                        const Monitor& monitor, run::PointExchange& exchange, unsigned threads = 0,
                        run::DeviceSource* device = nullptr);

/// Returns sentences on the pictures of an outcome: one for each panel whose `where` selects no row. The list
/// is empty after an early end, of which no pictures are drawn.
std::vector<std::string> findings_of(const LoadedModel& model, const Outcome& outcome);

}  // namespace stepwire::session
