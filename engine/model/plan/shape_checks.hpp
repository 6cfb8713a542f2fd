#pragma once

#include <set>
#include <string>
#include <utility>

#include "engine/model/plan/port_sizes.hpp"

namespace stepwire::plan {

/// Lists of inputs, block and input.
using ListInputs = std::set<std::pair<std::size_t, std::size_t>>;

/// a b, but no more than what is refused anyway.
Eigen::Index bounded_product(Eigen::Index a, Eigen::Index b);
/// What feeds, as messages name it.
std::string source_name(const Draft& draft, const diagram::Source& source);
/// The same in quotes, or "this" for numbers.
std::string quoted_source(const Draft& draft, const diagram::Source& source);
/// Refuses what shows once all sizes are found: elements of lists that do not fit each other, elements that
/// their signals have not, matrices that are none, and what is too small. Of lists that are `refused` enough
/// has been said.
void check_shapes(Draft& draft, PortSizes& sizes, const ListInputs& refused);

}  // namespace stepwire::plan
