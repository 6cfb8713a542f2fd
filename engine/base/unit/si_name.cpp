#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {
namespace {

using Exponents = std::array<double, 7>;

/// Usual names in mechanics and its electrics; the first match is used. J is missing: in diagrams of forces
/// and torques this dimension is nearly always a torque.
constexpr std::pair<std::string_view, Exponents> usual[] = {
    {"N", {1, 1, -2}},           {"N m", {2, 1, -2}},
    {"N/m", {0, 1, -2}},         {"N s/m", {0, 1, -1}},
    {"N m s", {2, 1, -1}},       {"N s", {1, 1, -1}},
    {"N/s", {1, 1, -3}},         {"N m/s^2", {2, 1, -4}},
    {"Pa", {-1, 1, -2}},         {"Pa s", {-1, 1, -1}},
    {"Pa/s", {-1, 1, -3}},       {"W", {2, 1, -3}},
    {"V", {2, 1, -3, -1}},       {"ohm", {2, 1, -3, -2}},
    {"V/m", {1, 1, -3, -1}},     {"V/s", {2, 1, -4, -1}},
    {"H", {2, 1, -2, -2}},       {"F", {-2, -1, 4, 2}},
    {"T", {0, 1, -2, -1}},       {"N/A", {1, 1, -2, -1}},
    {"N m/A", {2, 1, -2, -1}},   {"N s/(m A)", {0, 1, -1, -1}},
    {"N/(m A)", {0, 1, -2, -1}}, {"m/N", {0, -1, 2}},
    {"m/(N s)", {0, -1, 1}},     {"A/N", {-1, -1, 2, 1}},
    {"A/V", {-2, -1, 3, 2}},     {"V/N", {1, 0, -1, -1}},
    {"1/N", {-1, -1, 2}},        {"1/V", {-2, -1, 3, 1}},
    {"1/Pa", {1, -1, 2}},        {"N^2", {2, 2, -4}},
    {"W/K", {2, 1, -3, 0, -1}},
};

constexpr std::array<std::string_view, 7> symbols{"m", "kg", "s", "A", "K", "mol", "cd"};
constexpr std::array<std::size_t, 7> writing_order{1, 0, 2, 3, 4, 5, 6};  // "kg m^2", mass first

std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

/// Returns the base units with an exponent of this sign, and their number.
std::pair<std::string, int> base_units(const Exponents& exponents, double sign) {
  std::string text;
  int count = 0;
  for (const std::size_t i : writing_order) {
    const double exponent = exponents[i] * sign;
    if (!(exponent > 0.0)) continue;
    if (count++ > 0) text += ' ';
    text += symbols[i];
    if (exponent != 1.0) text += '^' + shortest(exponent);
  }
  return {text, count};
}

/// True for an angle and its first two time derivatives. A torque per angle does not count, since engineers
/// read it as a torque.
bool is_angular(const Dimension& dimension) {
  Exponents others = dimension.exponents;
  const double time = std::exchange(others[2], 0.0);
  return dimension.angle == 1.0 && others == Exponents{} && (time == 0.0 || time == -1.0 || time == -2.0);
}

/// True for a number of periods per time.
bool is_frequency(const Dimension& dimension) {
  return dimension.cycles == 1.0 && dimension.angle == 0.0 && dimension.exponents == Exponents{0, 0, -1};
}

}  // namespace

std::string si_name(const Dimension& dimension) {
  if (is_frequency(dimension)) return "Hz";
  if (is_angular(dimension)) {
    const double time = -dimension.exponents[2];
    return time == 0.0 ? "rad" : time == 1.0 ? "rad/s" : "rad/s^2";
  }
  for (const auto& [name, exponents] : usual) {
    if (exponents == dimension.exponents) return std::string(name);
  }
  const auto [above, many_above] = base_units(dimension.exponents, 1.0);
  const auto [below, many_below] = base_units(dimension.exponents, -1.0);
  const std::string numerator = many_above > 0 ? above : "1";
  if (many_below == 0) return numerator;
  return numerator + (many_below > 1 ? "/(" + below + ")" : "/" + below);
}

}  // namespace stepwire::unit
