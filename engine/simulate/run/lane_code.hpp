#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/run/background_compilation.hpp"

namespace stepwire::run {

/// Whether runs that differ in numbers only are stepped together. The results are the same to the last bit.
enum class LaneUse {
  automatic,  ///< once compiling the plan for it is worth it and done
  at_once,    ///< from the first run on, where that can be
  never
};

/// Compiles the plans of some runs for several runs at once, and decides by measurement which of them are
/// stepped so.
class LaneCode {
 public:
  /// A plan of some runs.
  struct Member {
    const plan::Plan* plan;
    plan::RunDifferences differences;
    std::optional<std::size_t> runs{};  ///< nothing: nobody knows, and as much is expected as has been done
  };

  LaneCode(LaneUse use, plan::CodeSource* source, std::vector<Member> members);

  /// The code of the i-th plan; null while there is none, and where its runs go one by one. From any thread.
  const plan::CompiledLanes* code(std::size_t member) const;
  /// Has it been found out which way is the faster one?
  bool is_decided(std::size_t member) const { return states_[member].decided; }
  /// Says what has been found out: nothing against it, or why the runs go one by one. From any thread.
  void decide(std::size_t member, const std::string& why_not = "");
  /// Notes that so many more ticks of all are done. From any thread.
  void done(std::int64_t ticks) { compilation_.done(ticks); }

  /// Runs that are stepped together; 1: none were to be.
  int lanes() const;
  /// The same once code is there, of any plan for which some is sought.
  int most_lanes() const;
  /// Why runs went one by one: a sentence; empty where none had to.
  std::string why_not() const;

 private:
  struct State {
    plan::CompiledLanes code;
    std::atomic<bool> ready = false, decided = false;
  };

  bool compile(const plan::CodeLimits& limits);
  void refuse(std::size_t member, const std::string& why);

  plan::CodeSource* source_;
  std::vector<Member> members_;
  std::vector<State> states_;
  bool seeks_ = false;        ///< code for some plan
  mutable std::mutex mutex_;  ///< of the reason
  std::string why_not_;
  BackgroundCompilation compilation_;  ///< last: it uses the others
};

}  // namespace stepwire::run
