#pragma once

#include "engine/model/block/registry.hpp"

namespace stepwire::cli {

/// Runs the program with these arguments and returns its exit code (see ExitCode). `blocks` makes the
/// registry; its exceptions are reported like all others.
int run_command_line(int argc, char** argv, Registry (*blocks)());

}  // namespace stepwire::cli
