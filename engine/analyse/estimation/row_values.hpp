#pragma once

#include <vector>

#include "engine/analyse/query/formula.hpp"

namespace stepwire {

/// Value of a formula in each row of a recording, without evaluating where it is a column.
std::vector<double> values_of(const Formula& formula, const Recording& recording);

}  // namespace stepwire
