#include "engine/base/unit/unit.hpp"

#include <charconv>
#include <cmath>

#include "engine/base/unit/decimal.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::unit {
namespace {

constexpr std::size_t kelvin = 4;

template <class Combine>
Dimension combine(const Dimension& a, const Dimension& b, Combine&& with) {
  Dimension result;
  for (std::size_t i = 0; i < result.exponents.size(); ++i) {
    result.exponents[i] = with(a.exponents[i], b.exponents[i]);
  }
  result.angle = with(a.angle, b.angle);
  result.cycles = with(a.cycles, b.cycles);
  result.per_difference =
      (a.per_difference || b.per_difference) && result.exponents[kelvin] != 0.0 && !is_temperature(result);
  return result;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// True where a number starts here; it excludes "inf" and "nan".
bool starts_number(std::string_view text) {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  if (!text.empty() && text.front() == '.') text.remove_prefix(1);
  return !text.empty() && text.front() >= '0' && text.front() <= '9';
}

}  // namespace

Dimension operator*(const Dimension& a, const Dimension& b) {
  return combine(a, b, [](double x, double y) { return x + y; });
}

Dimension operator/(const Dimension& a, const Dimension& b) {
  return combine(a, b, [](double x, double y) { return x - y; });
}

Dimension power(const Dimension& a, double exponent) {
  return combine(a, a, [exponent](double x, double) { return x == 0.0 ? 0.0 : x * exponent; });
}

double Unit::to_si(double value) const {
  if (scale == 1.0L && offset == 0.0L) return value;
  return static_cast<double>(offset + scale * as_decimal(value));
}

double Unit::from_si(double value) const {
  if (scale == 1.0L && offset == 0.0L) return value;
  return static_cast<double>((as_decimal(value) - offset) / scale);
}

/// Caches the last unit of the thread: lists and sweeps parse the same unit many times in a row.
static std::optional<Unit> known_unit(std::string_view text) {
  thread_local std::string last;
  thread_local std::optional<Unit> unit;
  if (text != last) {
    unit = parse_unit(text);
    last = text;
  }
  return unit;
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  if (!starts_number(text)) return std::nullopt;
  Quantity result;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, result.value);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view unit_text = trimmed({rest, static_cast<std::size_t>(end - rest)});
  if (unit_text.empty()) return result;
  const auto unit = known_unit(unit_text);
  if (!unit || unit_text == "1") return std::nullopt;
  const double written = result.value;
  result.value = unit->to_si(result.value);
  result.dimension = unit->dimension;
  const bool vanished = result.value == 0.0 && written != 0.0 && unit->offset == 0.0L;
  if (!std::isfinite(result.value) || vanished) return std::nullopt;
  return result;
}

}  // namespace stepwire::unit
