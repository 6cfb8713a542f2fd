#pragma once

#include <optional>
#include <span>

#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// Throws ExpressionError where `uniform` or `lognormal` has a seed or stream that is not a whole number,
/// since the draw would be NaN. `values` has one entry for each variable in order. A draw is not checked
/// where it depends on an unknown value (std::nullopt), and of a choice with a known condition only the
/// branch taken.
void check_draws(const Program& program, std::span<const std::optional<double>> values);

}  // namespace stepwire::expression
