#pragma once

#include <string>

#include "engine/app/session/loop_outcome.hpp"

namespace stepwire::report {

/// What a loop has to tell, for people.
std::string loop_text(const session::LoopOutcome& outcome);

}  // namespace stepwire::report
