#pragma once

#include <string>

#include "engine/app/cli/progress.hpp"
#include "engine/app/session/monitor.hpp"

namespace stepwire::cli {

/// Returns the monitor of the command line: a progress bar on the terminal, diagnostics on the standard
/// error, and interruption by signals. `progress` nullptr: no bar.
session::Monitor terminal_monitor(Progress* progress);

}  // namespace stepwire::cli
