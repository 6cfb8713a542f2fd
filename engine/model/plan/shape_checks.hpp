#pragma once

#include <set>
#include <string>
#include <utility>

#include "engine/model/plan/port_sizes.hpp"

namespace stepwire::plan {

/// List inputs, as block and input.
using ListInputs = std::set<std::pair<std::size_t, std::size_t>>;

/// Returns a b, capped at a size that is refused anyway.
Eigen::Index bounded_product(Eigen::Index a, Eigen::Index b);
/// Returns the name of a source for messages.
std::string source_name(const Draft& draft, const diagram::Source& source);
/// Returns that name in quotes, or "this" for numbers.
std::string quoted_source(const Draft& draft, const diagram::Source& source);
/// Refuses faults that show only after all sizes are known: incompatible elements of lists, missing elements,
/// invalid matrices, and sizes that are too small. The lists in `refused` already have a fault.
void check_shapes(Draft& draft, PortSizes& sizes, const ListInputs& refused);

}  // namespace stepwire::plan
