#pragma once

#include <span>
#include <vector>

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

  /// What figures and claims read.
  std::span<const record::Recording> recordings() const { return shown.empty() ? result.recordings : shown; }
  /// Did it end before its time, by a fault or an interruption?
  bool early() const { return !result.faults.empty() || result.interrupted; }
};

/// Adds what the scene shows and linear analyses to what figures and claims read.
void add_shown(const LoadedModel& model, Outcome& outcome);

/// Judges all claims on what was recorded; those about a run that ended early do not hold.
void judge_claims(const LoadedModel& model, Outcome& outcome);

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
