#pragma once

#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"

namespace stepwire::session {

/// Returns sentences on the pictures of an outcome: one for each panel whose `where` selects no row. The list
/// is empty after an early end, of which no pictures are drawn.
std::vector<std::string> findings_of(const LoadedModel& model, const Outcome& outcome);

}  // namespace stepwire::session
