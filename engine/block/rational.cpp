#include "engine/block/rational.hpp"

#include <fmt/format.h>

namespace stepwire {

namespace {

Eigen::VectorXd without_leading_zeros(const Eigen::VectorXd& coefficients) {
  Eigen::Index first = 0;
  while (first + 1 < coefficients.size() && coefficients[first] == 0.0) ++first;
  return coefficients.tail(coefficients.size() - first);
}

}  // namespace

std::string Rational::problem_of(const Eigen::VectorXd& numerator, const Eigen::VectorXd& denominator) {
  if (denominator.size() < 2)
    return "the denominator needs at least two coefficients; without a pole this is a Gain";
  if (denominator[0] == 0.0) return "the denominator's first coefficient is 0; leave it out";
  if (numerator.size() == 0) return "the numerator needs at least one coefficient";
  const Eigen::Index above = without_leading_zeros(numerator).size() - 1, below = denominator.size() - 1;
  if (above <= below) return "";
  return fmt::format("the numerator has degree {} and the denominator {}; it must not be higher", above,
                     below);
}

Rational::Rational(const Eigen::VectorXd& numerator, const Eigen::VectorXd& denominator) {
  const Eigen::Index n = denominator.size() - 1;
  const Eigen::VectorXd above = without_leading_zeros(numerator);
  Eigen::ArrayXd b = Eigen::ArrayXd::Zero(n + 1);
  b.tail(above.size()) = above.array() / denominator[0];
  a = denominator.tail(n).array() / denominator[0];
  direct = b[0];
  c = b.tail(n) - direct * a;
}

}  // namespace stepwire
