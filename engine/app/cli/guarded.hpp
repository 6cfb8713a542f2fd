#pragma once

#include <functional>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::cli {

/// Does something that may fail as users' things do, prints why on the standard error (one line each), and
/// returns the code that fits. What is wrong goes to `faults` as data, too, where that is not null.
ExitCode guarded(const std::function<ExitCode()>& action, json::Json* faults = nullptr);

/// Why runs ended early, on the standard error; of many runs the first few.
void print_faults(const run::RunResult& result);

}  // namespace stepwire::cli
