#pragma once

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Adds a fault for a claim whose verdict does not depend on the run. Either no formula reads anything of the
/// run, or the comparison accepts every number that the reduction can return ('fraction' at least 0).
void check_can_fail(const yaml::Node& node, const Claim& claim, const query::NamesReading& read);

}  // namespace stepwire::claim
