#pragma once

#include <optional>
#include <span>

#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// Throws ExpressionError where `uniform` or `lognormal` draws by a seed or a stream that is not whole, which
/// gives two people one number or none at all. Values of variables stand in their order; where one is not
/// known, nothing is said of what hangs on it, and of a choice only the branch that is taken counts.
void check_draws(const Program& program, std::span<const std::optional<double>> values);

}  // namespace stepwire::expression
