#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/run/background_compilation.hpp"

namespace stepwire::run {

/// Policy for stepping runs in lanes, if they differ in numbers only. The results are the same to the last
/// bit.
enum class LaneUse {
  automatic,  ///< once compiling the plan for lanes is worth it and done
  at_once,    ///< from the first run, if the plan allows it
  never
};

/// Compiles plans for lanes of several runs, and decides by measurement which plans use them.
class LaneCode {
 public:
  LaneCode(LaneUse use, plan::CodeSource* source, std::vector<PlanOfRuns> members);

  /// Returns the lane code of the plan with index `member`. Returns nullptr while it is not ready, and if its
  /// runs are stepped one by one. Thread-safe.
  const plan::CompiledLanes* code(std::size_t member) const;
  /// True once the measurement of a plan is finished.
  bool is_decided(std::size_t member) const { return states_[member].decided; }
  /// Stores the result of the measurement: the reason why lanes are not used, or an empty text if they are.
  /// Thread-safe.
  void decide(std::size_t member, const std::string& why_not = "");
  /// Adds `ticks` to the number of done ticks of all runs. Thread-safe.
  void done(std::int64_t ticks) { compilation_.done(ticks); }

  /// Returns the number of lanes; 1 if no code uses lanes.
  int lanes() const;
  /// Returns the number of lanes that the compiled code will have, of any plan to be compiled.
  int most_lanes() const;
  /// Returns the reason why runs were stepped one by one, as a sentence; an empty text if all used lanes.
  std::string why_not() const;

 private:
  struct State {
    plan::CompiledLanes code;
    std::atomic<bool> ready = false, decided = false;
  };

  bool compile(const plan::CodeLimits& limits);
  void refuse(std::size_t member, const std::string& why);

  plan::CodeSource* source_;
  std::vector<PlanOfRuns> members_;
  std::vector<State> states_;
  bool seeks_ = false;        ///< true if the code of some plan is to be compiled
  mutable std::mutex mutex_;  ///< guards why_not_
  std::string why_not_;
  BackgroundCompilation compilation_;  ///< last member: its thread uses the others
};

}  // namespace stepwire::run
