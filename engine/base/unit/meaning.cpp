#include "engine/base/unit/meaning.hpp"

#include <cmath>

namespace stepwire::unit {
namespace {

std::string other_rate(const Dimension& given, const Dimension& wanted) {
  if (!mixes_rates(given / wanted)) return "";
  return wanted.cycles != 0.0 ? "is an angle per time, and a period has 2*pi rad"
                              : "counts periods per time, of which each has 2*pi rad";
}

std::string other_temperature(const Dimension& given, const Dimension& wanted) {
  if (!given.zeros || !is_temperature(given)) return "";
  if (!are_zeros(*given.zeros, 0.0) && !are_zeros(*given.zeros, 1.0))
    return "adds or scales temperatures in degC, whose zero is none; subtract them, or take their mean";
  if (!wanted.zeros || are_zeros(*given.zeros, *wanted.zeros)) return "";
  if (are_zeros(*wanted.zeros, 0.0)) return "is a temperature, but a difference of temperatures is meant";
  // Zeros other than 0 and 1 are a fault of the second dimension, not of the first.
  return are_zeros(*wanted.zeros, 1.0) ? "is a difference of temperatures, but a temperature is meant" : "";
}

}  // namespace

bool is_temperature(const Dimension& dimension) {
  return dimension.exponents == std::array<double, 7>{0, 0, 0, 0, 1};
}

bool are_zeros(double zeros, double wanted) {
  constexpr double rounding = 1e-9;
  return std::abs(zeros - wanted) <= rounding;
}

bool mixes_rates(const Dimension& quotient) {
  return quotient.cycles * quotient.angle < 0.0 && quotient.cycles + quotient.angle == 0.0;
}

std::string other_meaning(const Dimension& given, const Dimension& wanted) {
  if (given != wanted) return "";
  const std::string rate = other_rate(given, wanted);
  return rate.empty() ? other_temperature(given, wanted) : rate;
}

std::string other_meaning_of_number(const Dimension& given, const Dimension& wanted) {
  const std::string other = other_meaning(given, wanted);
  if (other.empty()) return "";
  const bool of_temperatures = is_temperature(wanted);
  const char* cure = wanted.cycles != 0.0 ? "Hz" : "rad/s";
  if (of_temperatures) cure = wanted.zeros && *wanted.zeros > 0.5 ? "degC or K" : "K or delta_degC";
  return other + "; write it in " + cure;
}

std::string cure_of_rate(const Dimension& wanted) {
  return wanted.cycles != 0.0 ? "divide by 2*pi" : "multiply by 2*pi";
}

std::optional<double> joined_zeros(const std::optional<double>& a, const std::optional<double>& b,
                                   bool subtracts) {
  if (a && b) return subtracts ? *a - *b : *a + *b;
  const bool first = a && are_zeros(*a, 1.0), second = b && are_zeros(*b, 1.0);
  if (subtracts) return second ? std::optional(0.0) : std::nullopt;
  return first || second ? std::optional(1.0) : std::nullopt;
}

}  // namespace stepwire::unit
