#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace stepwire::unit {

/// Exponents of m, kg, s, A, K, mol, cd. Halves occur (square roots). Angles have no exponent: a radian is 1.
/// The other members are the meaning of a number, see meaning.hpp; equality ignores them.
struct Dimension {
  std::array<double, 7> exponents{};
  double angle = 0.0;   ///< exponent of rad
  double cycles = 0.0;  ///< exponent of Hz; 1/s has none

  /// Sum of temperature zeros: 1 for a temperature (degC), 0 for a difference of two (delta_degC),
  /// std::nullopt if unknown and for products and powers.
  std::optional<double> zeros{};

  /// True for a product or power with degC or delta_degC in it, such as W/degC. It is a factor of differences
  /// of temperatures. Products and powers keep it unless the temperature cancels; K alone has none.
  bool per_difference = false;

  bool operator==(const Dimension& other) const { return exponents == other.exponents; }
};

Dimension operator*(const Dimension& a, const Dimension& b);
Dimension operator/(const Dimension& a, const Dimension& b);
Dimension power(const Dimension& a, double exponent);

/// Returns the SI unit of a dimension in an engineer's notation: "N", "N m", "m/s", "A/m", "1". Without a
/// usual name it is a product of base units such as "kg m^2/(s^3 K)". parse_unit reads it back.
std::string si_name(const Dimension& dimension);

/// Conversion to SI: value_si = offset + scale * value. Scale and offset are wider than a double, and values
/// count as the decimals that were written. So 0.1 ms is the double nearest to 0.0001 and not its neighbour.
struct Unit {
  long double scale = 1.0L;
  long double offset = 0.0L;
  Dimension dimension;

  double to_si(double value) const;
  double from_si(double value) const;
};

/// Parses "mm/s", "lbf.in", "N m", "N*m", "1/s", "m^2", "m2", "s-1", "J/(kg K)", "%", "deg", "rev", "degC",
/// "µm", "" (dimensionless). Returns std::nullopt for other texts. Blank, '.', '*' and '/' have equal
/// precedence, from left to right. An offset ("degC") applies only to a single unit. Thread-safe.
std::optional<Unit> parse_unit(std::string_view text);

/// A number with an optional unit; `value` is SI with a unit and as written without.
struct Quantity {
  double value = 0.0;
  std::optional<Dimension> dimension;
};

/// Parses "5 mm", "-0.35 A", "2e-3", "1 kHz", "1 1/s". Returns std::nullopt for other texts. "inf", "nan",
/// hexadecimals and numbers out of the range of a double are not accepted.
std::optional<Quantity> parse_quantity(std::string_view text);

/// Returns the length of the longest start of `text` that is a unit; 0 without one. It is "mm/s" of "mm/s +
/// x", and "A" of "A/x" where x is no unit. A unit here has no blanks inside and ends where a name ends:
/// "sin(x)" and "s.x" start with none. After '*' or '/' a name that is `taken` is no unit: only "A" of "A/m"
/// where m is a signal.
std::size_t unit_prefix(std::string_view text, const std::function<bool(std::string_view)>& taken = {});

}  // namespace stepwire::unit
