#pragma once

#include <string>

#include "engine/app/session/loop_outcome.hpp"

namespace stepwire {

/// What a loop has to tell, for people.
std::string loop_text(const LoopOutcome& outcome);

}  // namespace stepwire
