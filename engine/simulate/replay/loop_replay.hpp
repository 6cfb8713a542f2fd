#pragma once

#include "engine/simulate/replay/recorded.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::replay {

/// Number of columns of a loop's table before its signals: time, tick, wall.
inline constexpr std::size_t first_signal_of_loop = 3;

/// Steps a plan tick by tick with the recorded inputs, and compares the rows by their ticks. Adds the result
/// to `verification`. Throws Error if ticks or inputs are not as a loop writes them.
void replay_loop(const plan::Plan& plan, const std::vector<Recorded>& tables, const std::string& inputs_file,
                 const run::RunOptions& options, Verification& verification);

}  // namespace stepwire::replay
