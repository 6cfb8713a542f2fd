#pragma once

#include <vector>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

/// Returns the blocks in an order determined by their types and wires alone. It does not depend on their
/// order in the file, so a reordered file gives the same bits. Sums over states and the choice among equal
/// tears of a loop use this order. Blocks with the same types and wires are ordered by name. Parameter values
/// have no influence, since they may change without a new plan. Sizes of ports have an influence once they
/// are known.
std::vector<int> canonical_order(const Draft& draft);

}  // namespace stepwire::plan
