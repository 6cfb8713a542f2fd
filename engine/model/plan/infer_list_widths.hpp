#pragma once

#include <set>
#include <utility>

#include "engine/model/plan/matrix_lists.hpp"

namespace stepwire::plan {

/// Of all ports and states together: beyond, a delay or a chain of Mux blocks was meant to be shorter.
constexpr Eigen::Index max_numbers = Eigen::Index{1} << 26;

/// Finds every size that declarations and wires leave open. Lists follow from their elements: a list input
/// takes elements of one size or of one element; with the shape "+m" each element has its own size and m is
/// their sum, and so do the sums of lists of matrices. What follows from no other open size is a scalar, and
/// where open sizes follow from each other alone (a loop), so is one of them. Returns the lists (block and
/// input) whose size had to be refused.
std::set<std::pair<std::size_t, std::size_t>> infer_list_widths(Draft& draft, PortSizes& sizes,
                                                                MatrixLists& matrices);

}  // namespace stepwire::plan
