#pragma once

#include <string>

#include "engine/app/session/loop_run.hpp"

namespace stepwire::report {

/// Returns the measurements of a real-time loop as text for the terminal.
std::string loop_text(const session::LoopOutcome& outcome);

}  // namespace stepwire::report
