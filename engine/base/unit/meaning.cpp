#include "engine/base/unit/meaning.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace stepwire::unit {
namespace {

/// True for an angle per time and for a number of periods per time, without any other factor.
bool is_rate(const Dimension& dimension) {
  const bool one = dimension.angle + dimension.cycles == 1.0 && dimension.angle * dimension.cycles == 0.0;
  return one && dimension.exponents == std::array<double, 7>{0, 0, -1};
}

std::string raised(const char* name, double exponent) {
  return exponent == 1.0 ? name : fmt::format("{}^{}", name, exponent);
}

/// Returns the SI unit with its angles and periods, which the usual name leaves out: "V period/rad".
std::string full_name(const Dimension& dimension) {
  std::string name = si_name(Dimension{dimension.exponents});
  for (const auto& [factor, exponent] :
       {std::pair("rad", dimension.angle), std::pair("period", dimension.cycles)})
    if (exponent > 0.0)
      name = name.starts_with('1') ? raised(factor, exponent) + name.substr(1)
                                   : name + " " + raised(factor, exponent);
  for (const auto& [factor, exponent] :
       {std::pair("rad", dimension.angle), std::pair("period", dimension.cycles)})
    if (exponent < 0.0) name += "/" + raised(factor, -exponent);
  return name;
}

std::string other_rate(const Dimension& given, const Dimension& wanted) {
  if (!mixes_rates(given / wanted)) return "";
  if (!is_rate(given) || !is_rate(wanted))
    return fmt::format("is in {}, but {} is meant, and a period has 2*pi rad", full_name(given),
                       full_name(wanted));
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

std::string meaning_name(const Dimension& dimension) {
  if (is_temperature(dimension) && dimension.zeros)
    return *dimension.zeros > 0.5 ? "temperature_K" : "delta_degC";
  std::string name = si_name(dimension);
  const auto is_letter = [&](std::size_t i) {
    return std::isalpha(static_cast<unsigned char>(name[i])) != 0;
  };
  for (std::size_t i = name.size(); dimension.per_difference && i-- > 0;)
    if (name[i] == 'K' && (i == 0 || !is_letter(i - 1)) && (i + 1 == name.size() || !is_letter(i + 1)))
      name.replace(i, 1, "delta_degC");
  return name;
}

std::string refused_product(const std::optional<double>& zeros, const Dimension& factor) {
  if (!factor.per_difference || !zeros || are_zeros(*zeros, 0.0)) return "";
  return fmt::format(
      "is a temperature, but a factor in {} takes a difference of temperatures; subtract a "
      "reference temperature first, or write K in the factor of a temperature above absolute zero",
      meaning_name(factor));
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
  if (!of_temperatures && !is_rate(wanted)) return other;
  const char* cure = wanted.cycles != 0.0 ? "Hz" : "rad/s";
  if (of_temperatures) cure = wanted.zeros && *wanted.zeros > 0.5 ? "degC or K" : "K or delta_degC";
  return other + "; write it in " + cure;
}

std::string cure_of_rate(const Dimension& given, const Dimension& wanted) {
  const double angles = (given / wanted).angle;
  const std::string factor = std::abs(angles) == 1.0 ? "2*pi" : fmt::format("(2*pi)^{}", std::abs(angles));
  return (angles > 0.0 ? "divide by " : "multiply by ") + factor;
}

std::optional<double> joined_zeros(const std::optional<double>& a, const std::optional<double>& b,
                                   bool subtracts) {
  if (a && b) return subtracts ? *a - *b : *a + *b;
  const bool first = a && are_zeros(*a, 1.0), second = b && are_zeros(*b, 1.0);
  if (subtracts) return second ? std::optional(0.0) : std::nullopt;
  return first || second ? std::optional(1.0) : std::nullopt;
}

}  // namespace stepwire::unit
