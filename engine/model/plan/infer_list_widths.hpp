#pragma once

#include <set>
#include <utility>
#include <vector>

#include "engine/model/plan/matrix_lists.hpp"

namespace stepwire::plan {

/// Most numbers of all ports and states together; a larger total indicates a mistake in a delay or a chain of
/// Mux blocks.
constexpr Eigen::Index max_numbers = Eigen::Index{1} << 26;

/// Determines every size that declarations and wires leave open, and returns the lists (block and input)
/// whose size was refused.
///
/// The size of a list depends on its elements, which may themselves depend on other lists. A list input takes
/// elements of one size or scalars. With the shape "+m" each element has its own size, and m is their sum;
/// sums of lists of matrices are alike. The sizes are propagated by a worklist until no list changes. An open
/// size that then depends on no other open size becomes a scalar. Sizes that depend on each other in a loop
/// become scalars together; with a sum or a product among them only the first one in the order of the blocks
/// does. Propagation continues until no size is open.
std::set<std::pair<std::size_t, std::size_t>> infer_list_widths(Draft& draft, PortSizes& sizes,
                                                                MatrixLists& matrices,
                                                                const std::vector<int>& order);

}  // namespace stepwire::plan
