#pragma once

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Adds a fault where a claim holds or fails whatever the run does: nothing of it comes from the run, or its
/// comparison accepts every number that its reduction can give ('fraction' at least 0).
void check_can_fail(const yaml::Node& node, const Claim& claim, const query::NamesReading& read);

}  // namespace stepwire::claim
