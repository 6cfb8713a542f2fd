#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stepwire {

/// Exponents of m, kg, s, A, K, mol, cd. Angles have none: a radian is 1. Halves occur (square roots).
struct Dimension {
  std::array<double, 7> exponents{};
  bool operator==(const Dimension&) const = default;
};

Dimension operator*(const Dimension& a, const Dimension& b);
Dimension operator/(const Dimension& a, const Dimension& b);
Dimension power(const Dimension& a, double exponent);

/// The SI unit of a dimension as an engineer writes it: "N", "N m", "m/s", "A/m", "1".
std::string si_name(const Dimension& dimension);

/// A unit as text, and how its numbers become SI: value_si = offset + scale * value.
struct Unit {
  double scale = 1.0;
  double offset = 0.0;
  Dimension dimension;

  double to_si(double value) const { return offset + scale * value; }
  double from_si(double value) const { return (value - offset) / scale; }
};

/// Reads "mm/s", "lbf.in", "N m", "1/s", "%", "deg", "rev", "degC", "" (dimensionless); nothing if it is no unit.
std::optional<Unit> parse_unit(std::string_view text);

/// A number with its unit if it has one; `value` is SI then, and exactly as written otherwise.
struct Quantity {
  double value = 0.0;
  std::optional<Dimension> dimension;
};

/// Reads "5 mm", "-0.35 A", "2e-3", "1 kHz", "1 1/s"; nothing if the text is no number with an optional unit.
/// "inf" and "nan" and what overflows are no numbers.
std::optional<Quantity> parse_quantity(std::string_view text);

/// Length of the longest start of `text` that is a unit ("mm/s" of "mm/s + x", "A" of "A/x" where x is no unit);
/// 0 if there is none. A unit here has no blanks inside.
std::size_t unit_prefix(std::string_view text);

}  // namespace stepwire
