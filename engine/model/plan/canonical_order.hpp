#pragma once

#include <vector>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

/// Returns the blocks in an order that follows from their types and wires alone. Their places in the file
/// have no part in it, so the same blocks in another order give the same bits. Sums over states and the
/// choice among equal tears of a loop follow this order. Blocks with the same types and wires are ordered by
/// name. Values of parameters have no part either, since they may change without another plan. Needs the
/// sizes of ports.
std::vector<int> canonical_order(const Draft& draft);

}  // namespace stepwire::plan
