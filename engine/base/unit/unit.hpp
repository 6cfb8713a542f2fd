#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace stepwire::unit {

/// Exponents of m, kg, s, A, K, mol, cd. Halves occur (square roots). Angles have none: a radian is 1. The
/// other members are the meaning of a number; two dimensions that differ in them alone are equal, see
/// meaning.hpp.
struct Dimension {
  std::array<double, 7> exponents{};
  double angle = 0.0;   ///< exponent of rad
  double cycles = 0.0;  ///< exponent of Hz; 1/s has none

  /// The zeros of temperature scales in a sum of temperatures: 1 in a temperature (degC), 0 in a difference
  /// of two (delta_degC). Products and powers have none.
  std::optional<double> zeros{};

  bool operator==(const Dimension& other) const { return exponents == other.exponents; }
};

Dimension operator*(const Dimension& a, const Dimension& b);
Dimension operator/(const Dimension& a, const Dimension& b);
Dimension power(const Dimension& a, double exponent);

/// The SI unit of a dimension as an engineer writes it: "N", "N m", "m/s", "A/m", "1"; a product of base
/// units such as "kg m^2/(s^3 K)" where no name is usual. parse_unit reads it back.
std::string si_name(const Dimension& dimension);

/// How the numbers of a unit become SI: value_si = offset + scale * value. Scale and offset are wider than a
/// double, and numbers are taken as the decimals they were written as, so that 0.1 ms is the double next to
/// 0.0001 and not its neighbour.
struct Unit {
  long double scale = 1.0L;
  long double offset = 0.0L;
  Dimension dimension;

  double to_si(double value) const;
  double from_si(double value) const;
};

/// Reads "mm/s", "lbf.in", "N m", "N*m", "1/s", "m^2", "m2", "s-1", "J/(kg K)", "%", "deg", "rev", "degC",
/// "µm",
/// "" (dimensionless); nothing if it is no unit. Blank, '.', '*' and '/' bind alike, from left to right. An
/// offset
/// ("degC") counts only where the unit stands alone. Safe from several threads.
std::optional<Unit> parse_unit(std::string_view text);

/// A number with its unit if it has one; `value` is SI then, and exactly as written otherwise.
struct Quantity {
  double value = 0.0;
  std::optional<Dimension> dimension;
};

/// Reads "5 mm", "-0.35 A", "2e-3", "1 kHz", "1 1/s"; nothing if the text is no number with an optional unit.
/// "inf" and "nan", hexadecimals and what is too large or too small for a double are no numbers.
std::optional<Quantity> parse_quantity(std::string_view text);

/// Length of the longest start of `text` that is a unit ("mm/s" of "mm/s + x", "A" of "A/x" where x is no
/// unit); 0 if there is none. A unit here has no blanks inside and ends where a name ends: "sin(x)" and "s.x"
/// start with none. After '*' or '/' a name that is `taken` is no unit: "A" of "A/m" where m is a signal.
std::size_t unit_prefix(std::string_view text, const std::function<bool(std::string_view)>& taken = {});

}  // namespace stepwire::unit
