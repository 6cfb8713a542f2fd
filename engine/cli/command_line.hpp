#pragma once

#include "engine/block/registry.hpp"

namespace stepwire {

/// The program: reads its arguments, does what they ask, and returns the exit code (see ExitCode).
int run_command_line(int argc, char** argv, const Registry& registry);

}  // namespace stepwire
