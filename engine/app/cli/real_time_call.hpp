#pragma once

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/loop_run.hpp"

namespace stepwire::cli {

/// Runs a loop and prints its report; used by the verbs `loop` and `rig`.
ExitCode run_in_real_time(const session::LoopCall& call, const Registry& registry);

}  // namespace stepwire::cli
