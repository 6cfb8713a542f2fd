#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/simulate/run/lane_code.hpp"
#include "engine/simulate/run/lane_group.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// Run at time 0 and, afterwards, its end.
struct PendingRun {
  std::size_t index;  ///< index among several runs
  Executor* simulation;
  std::vector<record::Recorder>* recorders;
  RunEnd end{};
};

/// Steps runs of one plan in lanes, if that is possible and faster. Thread-safe.
class LaneRunner {
 public:
  /// The plans and `interrupt` must outlive it.
  LaneRunner(std::vector<PlanOfRuns> members, LaneUse use, plan::CodeSource* source,
             const std::atomic<bool>* interrupt)
      : use_(use), interrupt_(interrupt), code_(use, source, std::move(members)) {}

  /// Returns the number of runs of a member that fill the lanes.
  std::size_t at_once(std::size_t member) const;
  /// Returns the largest number of lanes that the code will have, of any plan to be compiled.
  int most_lanes() const { return code_.most_lanes(); }
  /// Runs all of them from time 0 to their ends. Returns false, with the runs unchanged, if they have to run
  /// one by one. The code of single runs is `alone`; nullptr while there is none.
  bool run(std::size_t member, const plan::CompiledPlan* alone, std::vector<PendingRun>& runs);
  /// Adds the ticks of a run that was made alone.
  void done(std::int64_t ticks) { code_.done(ticks); }

  LaneReport report() const { return {code_.lanes(), code_.why_not()}; }

 private:
  bool stays(std::size_t member, LaneGroup& group, const plan::CompiledPlan* alone,
             std::vector<PendingRun>& runs);
  bool is_faster(LaneGroup& group, Executor& alone, const plan::CompiledPlan* code) const;
  void go_on(LaneGroup& group);

  LaneUse use_;
  const std::atomic<bool>* interrupt_;
  LaneCode code_;
};

}  // namespace stepwire::run
