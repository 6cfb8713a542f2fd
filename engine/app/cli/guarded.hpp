#pragma once

#include <functional>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::cli {

/// Runs an action that may throw, prints exceptions on the standard error (one line per fault), and returns
/// the exit code. Faults are also appended to `faults` as JSON unless it is nullptr.
ExitCode guarded(const std::function<ExitCode()>& action, json::Json* faults = nullptr);

/// Prints why runs ended early, on the standard error; at most the first few of many runs.
void print_faults(const run::RunResult& result);

}  // namespace stepwire::cli
