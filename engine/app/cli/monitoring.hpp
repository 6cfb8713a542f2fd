#pragma once

#include <string>

#include "engine/app/cli/progress.hpp"
#include "engine/app/session/monitor.hpp"

namespace stepwire::cli {

/// What the command line shows while something goes on: a bar on the terminal, diagnostics on the standard
/// error, and the signals that interrupt it. The progress may be null: then no bar.
session::Monitor terminal_monitor(Progress* progress);

}  // namespace stepwire::cli
