#pragma once

#include <vector>

#include "engine/simulate/profile/profile.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::profile {

/// Measures the calls of one table of a plan, sample by sample.
class CallTimes {
 public:
  CallTimes(const plan::Plan& plan, const std::vector<plan::KernelCall>& batches);

  /// Measures each call at the present instant of a simulation. Only updates change its state.
  void sample(run::Executor& simulation, const Stopwatch& stopwatch);

  /// Returns how often the calls of a period are made in the whole run.
  using CallCount = std::function<std::int64_t(const plan::Period& period)>;
  /// Adds the time of the table in a whole run to each block's cost in a phase.
  void add_to(std::vector<BlockCost>& blocks, std::size_t phase, const CallCount& calls) const;

 private:
  struct Call {
    plan::KernelCall batch;
    std::vector<std::size_t> blocks;  ///< indices in the plan
    double seconds = 0.0;             ///< time of the call repeated alone, sum of all samples
    std::vector<double> alone{};      ///< the same for each of its blocks
  };

  const plan::Plan& plan_;
  std::vector<Call> calls_;
  double table_ = 0.0;  ///< time of the whole table [s], sum of all samples
  int samples_ = 0;
};

}  // namespace stepwire::profile
