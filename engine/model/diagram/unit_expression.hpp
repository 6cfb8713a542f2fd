#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/unit/unit.hpp"

namespace stepwire::diagram {

/// Declared unit of a port: a constant dimension times powers of unit variables.
struct UnitExpression {
  bool any = false;            ///< declared "*": unknown and unchecked
  bool is_difference = false;  ///< declared "delta 'u": a difference of two values in 'u
  unit::Dimension constant;
  std::vector<std::pair<std::string, double>> variables;  ///< name without the quote, exponent

  bool has(const std::string& variable) const {
    return std::ranges::any_of(variables, [&](const auto& term) { return term.first == variable; });
  }
};

/// Parses "N m/s", "'u", "'k 'u", "'u/s", "'u^0.5", "delta 'u", "'n by s" (of the last of some coefficients),
/// "*"; '/' applies only to the next factor. Returns std::nullopt for other texts.
std::optional<UnitExpression> parse_unit_expression(std::string_view text);

}  // namespace stepwire::diagram
