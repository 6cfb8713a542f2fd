#pragma once

#include <optional>
#include <span>

#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// Throws ExpressionError where `uniform` or `lognormal` has a seed or stream that is not a whole number.
/// Fractions would be truncated, so that two persons share one number. `values` has one entry for each
/// variable in order. Draws that depend on an unknown value (std::nullopt) are not checked, and of a choice
/// only the branch taken.
void check_draws(const Program& program, std::span<const std::optional<double>> values);

}  // namespace stepwire::expression
