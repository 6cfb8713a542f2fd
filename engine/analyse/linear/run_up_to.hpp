#pragma once

#include <memory>

#include "engine/simulate/run/executor.hpp"

namespace stepwire::linear {

/// Runs up to the first multiple of `base_ticks` at or after a time [s]. Throws Error with `place` if the run
/// is shorter or fails.
std::unique_ptr<run::Executor> run_up_to(const plan::Plan& plan, double time, std::int64_t base_ticks,
                                         const yaml::Place& place);

/// Throws Error with all blocks that a state-space analysis cannot describe.
void require_linear(const plan::Plan& plan);

}  // namespace stepwire::linear
