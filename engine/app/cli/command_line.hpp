#pragma once

#include "engine/model/block/registry.hpp"

namespace stepwire::cli {

/// The program: reads its arguments, does what they ask, and returns the exit code (see ExitCode). `blocks`
/// makes the registry, which may fail as all else does.
int run_command_line(int argc, char** argv, Registry (*blocks)());

}  // namespace stepwire::cli
