#include "engine/figure/homogeneity.hpp"

#include <cmath>
#include <limits>

namespace stepwire {
namespace {

constexpr int trial_points = 24;
constexpr double scale = 3.0;

/// Values of both signs from 1e-3 to 1e3, the same at every call (a Weyl sequence).
double trial_value(int point, std::size_t variable) {
  const double turns =
      0.618033988749895 * (point + 1) + 0.414213562373095 * static_cast<double>(variable + 1);
  const double part = turns - std::floor(turns);
  const bool negative = point % 3 == 2;
  return (negative ? -1.0 : 1.0) * std::pow(10.0, 6.0 * part - 3.0);
}

/// Exponent by which the value grows with one base unit at one point; nan where the point says nothing.
double exponent_at(const Expression& expression, const std::vector<Dimension>& variables, std::size_t base,
                   int point) {
  std::vector<double> values(variables.size()), scaled(variables.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = trial_value(point, i);
    scaled[i] = values[i] * std::pow(scale, variables[i].exponents[base]);
  }
  const double before = expression(values), after = expression(scaled);
  if (std::isnan(before) || std::isnan(after) || (before == 0.0 && after == 0.0)) return std::nan("");
  // Another sign in other units is no power of the unit.
  if (before * after <= 0.0) return std::numeric_limits<double>::infinity();
  return std::log(after / before) / std::log(scale);
}

std::optional<double> common_exponent(const Expression& expression, const std::vector<Dimension>& variables,
                                      std::size_t base) {
  std::optional<double> common;
  for (int point = 0; point < trial_points; ++point) {
    const double exponent = exponent_at(expression, variables, base, point);
    if (std::isnan(exponent)) continue;
    const double rounded = std::round(12.0 * exponent) / 12.0;
    if (!(std::abs(exponent - rounded) < 1e-6)) return std::nullopt;
    if (common && *common != rounded) return std::nullopt;
    common = rounded;
  }
  return common;
}

}  // namespace

std::optional<Dimension> dimension_of(const Expression& expression, const std::vector<Dimension>& variables) {
  Dimension result;
  if (variables.empty()) return std::nullopt;
  for (std::size_t base = 0; base < result.exponents.size(); ++base) {
    const auto exponent = common_exponent(expression, variables, base);
    if (!exponent) return std::nullopt;
    result.exponents[base] = *exponent;
  }
  return result;
}

}  // namespace stepwire
