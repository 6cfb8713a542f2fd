#pragma once

#include <memory>

#include "engine/simulate/run/executor.hpp"

namespace stepwire::linear {

/// A run, taken to the first multiple of `base_ticks` from a time [s] on. Throws Error with `place`
/// where the run does not last so long, and where it fails.
std::unique_ptr<run::Executor> run_up_to(const plan::Plan& plan, double time, std::int64_t base_ticks,
                                         const yaml::Place& place);

/// Refuses blocks that no analysis of states describes. Throws Error with all of them.
void require_linear(const plan::Plan& plan);

}  // namespace stepwire::linear
