#pragma once

#include <vector>

#include "engine/simulate/profile/profile.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::profile {

/// Times the calls of one table of a plan, sample by sample.
class CallTimes {
 public:
  CallTimes(const plan::Plan& plan, const std::vector<plan::KernelCall>& batches);

  /// Times each call at the present moment of a simulation. Updates change it; the others do not.
  void sample(run::Executor& simulation, const Stopwatch& stopwatch);

  /// How often the batches of a period are called in the whole run.
  using CallCount = std::function<std::int64_t(const plan::Period& period)>;
  /// Adds what the table takes in a whole run to each block's cost in a phase.
  void add_to(std::vector<BlockCost>& blocks, std::size_t phase, const CallCount& calls) const;

 private:
  struct Call {
    plan::KernelCall batch;
    std::vector<std::size_t> blocks;  ///< indices in the plan
    double seconds = 0.0;             ///< of all samples together, repeated alone
    std::vector<double> alone{};      ///< of each block, likewise
  };

  const plan::Plan& plan_;
  std::vector<Call> calls_;
  double table_ = 0.0;  ///< [s], of all samples together: every call, one behind the other
  int samples_ = 0;
};

}  // namespace stepwire::profile
