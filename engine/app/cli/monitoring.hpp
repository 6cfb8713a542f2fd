#pragma once

#include <string>

#include "engine/app/cli/progress.hpp"
#include "engine/app/session/monitor.hpp"

namespace stepwire::cli {

/// Returns the monitor of the command line. It shows a progress bar on the terminal and diagnostics on the
/// standard error, and signals interrupt its operation. Without `progress` there is no bar.
session::Monitor terminal_monitor(Progress* progress);

}  // namespace stepwire::cli
