#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/plan/compiled_plan.hpp"
#include "engine/plan/plan.hpp"

namespace stepwire {

/// Compiles trials together with probes, plans in which all differs that differs between trials: so the text
/// is the same for any trials, and what was compiled once is found again.
class TrialCode : public CodeSource {
 public:
  /// `ahead`: the probes are compiled at once, in a thread of their own, so that the code is there when the
  /// first trials ask for it, or soon after.
  TrialCode(CodeSource& source, std::vector<Plan> probes, bool ahead);

  /// Waits for what is compiled ahead; nothing where it is stopped before.
  std::vector<CompiledPlan> compile(const std::vector<const Plan*>& plans,
                                    const std::stop_token& stop) override;
  std::vector<double> numbers(const Plan& plan) const override { return source_.numbers(plan); }

 private:
  void compile_ahead(const std::stop_token& stop);
  std::vector<const Plan*> with_probes(std::vector<const Plan*> plans) const;

  CodeSource& source_;
  std::vector<Plan> probes_;
  std::mutex mutex_;
  std::condition_variable_any finished_;
  bool busy_ = false;
  std::jthread thread_;  ///< last: it uses the others
};

}  // namespace stepwire
