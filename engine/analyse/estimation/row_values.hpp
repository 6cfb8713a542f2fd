#pragma once

#include <vector>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::estimation {

/// Returns the value of a formula in each row of a recording; a formula that is a column is not evaluated.
std::vector<double> values_of(const query::Formula& formula, const record::Recording& recording);

}  // namespace stepwire::estimation
