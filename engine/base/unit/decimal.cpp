#include "engine/base/unit/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>

namespace stepwire::unit {
namespace {

constexpr int exact_powers = 27;  // 10^27 is the largest power of ten that is exact in an 80-bit long double

long double power_of_ten(int exponent) {
  long double result = 1.0L;
  for (int i = 0; i < exponent; ++i) result *= 10.0L;
  return result;
}

/// Converts "d.ddde-xx": the digits as an integer, then one multiplication or division.
long double from_scientific(std::string_view text, double fallback) {
  std::uint64_t digits = 0;
  int exponent = 0;
  const std::size_t mark = text.find('e');
  for (const char c : text.substr(0, mark)) {
    if (c != '.') digits = digits * 10 + static_cast<std::uint64_t>(c - '0');
  }
  const std::size_t sign = text[mark + 1] == '+' ? 1 : 0;
  std::from_chars(text.data() + mark + 1 + sign, text.data() + text.size(), exponent);
  exponent -= mark > 1 ? static_cast<int>(mark) - 2 : 0;
  if (std::abs(exponent) > exact_powers) return fallback;
  const auto whole = static_cast<long double>(digits);
  return exponent < 0 ? whole / power_of_ten(-exponent) : whole * power_of_ten(exponent);
}

long double of_digits(double value, int precision) {
  std::array<char, 40> text{};
  const auto format = std::chars_format::scientific;
  const auto end = precision < 0 ? std::to_chars(text.begin(), text.end(), value, format).ptr
                                 : std::to_chars(text.begin(), text.end(), value, format, precision).ptr;
  return from_scientific({text.data(), static_cast<std::size_t>(end - text.data())}, value);
}

/// Returns the decimal of `digits` digits if `value` is within two units in the last place of a double, else
/// 0.
long double short_decimal(long double value, int digits) {
  const long double decimal = of_digits(static_cast<double>(value), digits - 1);
  const long double tolerance = 2.0L * std::numeric_limits<double>::epsilon() * value;
  return std::abs(decimal - value) <= tolerance ? decimal : 0.0L;
}

}  // namespace

long double as_decimal(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const long double magnitude = of_digits(std::abs(value), -1);
  return value < 0.0 ? -magnitude : magnitude;
}

long double as_published(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return value;
  // Fewer digits first: almost any number is close to some decimal of 15 digits.
  for (const long double parts : {1.0L, 9.0L, 3600.0L, 180.0L / std::numbers::pi_v<long double>}) {
    if (const long double decimal = short_decimal(value * parts, 9); decimal > 0.0L) return decimal / parts;
  }
  if (const long double decimal = short_decimal(value, 15); decimal > 0.0L) return decimal;
  return value;
}

}  // namespace stepwire::unit
