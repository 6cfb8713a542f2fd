#pragma once

#include <vector>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::estimation {

/// Value of a formula in each row of a recording, without evaluating where it is a column.
std::vector<double> values_of(const query::Formula& formula, const record::Recording& recording);

}  // namespace stepwire::estimation
