#pragma once

#include <optional>
#include <vector>

#include "engine/expression/expression.hpp"
#include "engine/unit/unit.hpp"

namespace stepwire {

/// The dimension of an expression from the dimensions of its variables, found by trial: if metres are made k
/// times smaller, the value of a length becomes k times larger. Nothing where the value does not scale by one
/// and the same power at all trial points ("x + 5 mm", "sin(x)"), so that an answer is never a guess.
std::optional<Dimension> dimension_of(const Expression& expression, const std::vector<Dimension>& variables);

}  // namespace stepwire
