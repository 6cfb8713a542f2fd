#pragma once

#include <vector>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

/// Returns the blocks in an order that follows from what they are and how they are wired, not from their
/// places in the file: sums over states, and the choice among equal tears of a loop, follow it, so that a
/// file with its blocks in another order gives the same bits. Blocks that wiring cannot tell apart follow by
/// name. Values of parameters have no part in it, as they may change without another plan. Sizes of ports are
/// known by then.
std::vector<int> canonical_order(const Draft& draft);

}  // namespace stepwire::plan
