#include "engine/model/block/rational.hpp"

#include <fmt/format.h>

namespace stepwire {

namespace {

Numbers without_leading_zeros(const Numbers& coefficients) {
  Index first = 0;
  while (first + 1 < coefficients.size() && coefficients[first] == 0.0) ++first;
  return {coefficients.data() + first, coefficients.size() - first};
}

}  // namespace

std::string Rational::problem_of(const Numbers& numerator, const Numbers& denominator) {
  if (denominator.size() < 2)
    return "the denominator needs at least two coefficients; without a pole this is a Gain";
  if (denominator[0] == 0.0) return "the denominator's first coefficient is 0; leave it out";
  if (numerator.size() == 0) return "the numerator needs at least one coefficient";
  const Index above = without_leading_zeros(numerator).size() - 1, below = denominator.size() - 1;
  if (above <= below) return "";
  return fmt::format("the numerator has degree {} and the denominator {}; it must not be higher", above,
                     below);
}

Rational Rational::of(const Numbers& numerator, const Numbers& denominator) {
  const Index n = denominator.size() - 1;
  const Numbers above = without_leading_zeros(numerator);
  const Index zeros = n + 1 - above.size();  // before the numerator's coefficients
  const auto b = [&](Index i) { return i < zeros ? 0.0 : above[i - zeros] / denominator[0]; };
  Rational made;
  made.a = Numbers(denominator.data() + 1, n).map([&](double one) { return one / denominator[0]; });
  made.direct = b(0);
  Index i = 0;
  made.c = made.a.map([&](double one) { return b(++i) - made.direct * one; });
  return made;
}

}  // namespace stepwire
