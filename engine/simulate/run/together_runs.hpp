#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/simulate/run/lane_code.hpp"
#include "engine/simulate/run/lane_group.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// A run that stands at time 0, and how it has ended.
struct PendingRun {
  std::size_t index;  ///< which one of several
  Executor* simulation;
  std::vector<record::Recorder>* recorders;
  RunEnd end{};
};

/// Steps runs that have one plan together, where that can be and is faster. From any thread.
class TogetherRuns {
 public:
  using Members = std::vector<LaneCode::Member>;

  /// The plans and what `interrupt` points to must outlive it.
  TogetherRuns(Members members, LaneUse use, plan::CodeSource* source, const std::atomic<bool>* interrupt)
      : use_(use), interrupt_(interrupt), code_(use, source, std::move(members)) {}

  /// How many runs of a member are to be given to run().
  std::size_t at_once(std::size_t member) const;
  /// The same of any plan for which code is sought, once that is there.
  int most_lanes() const { return code_.most_lanes(); }
  /// Runs them, which stand at time 0, to their ends. False, and nothing has happened, where they have to go
  /// one by one. `alone` is the code that they go with then; null: none is there.
  bool run(std::size_t member, const plan::CompiledPlan* alone, std::vector<PendingRun>& runs);
  /// Notes that a run has made so many ticks alone.
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
