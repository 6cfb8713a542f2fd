#pragma once

#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/math/function.hpp"

namespace stepwire::expression {

/// Wraps an expression as a Function for blocks: its variable i is the number v[places[i]].
Function function_of(Expression expression, std::vector<std::size_t> places);

}  // namespace stepwire::expression
