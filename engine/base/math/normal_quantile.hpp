#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/math/random.hpp"

namespace stepwire {

namespace detail {

/// A ratio of two polynomials of degree 7, lowest power first.
struct RatioOfPolynomials {
  std::array<double, 8> above, below;

  double operator()(double x) const { return horner(above, x) / horner(below, x); }

  static double horner(const std::array<double, 8>& coefficients, double x) {
    double sum = 0.0;
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
    return sum;
  }
};

inline constexpr RatioOfPolynomials central{
    {3.387132872796366608, 133.14166789178437745, 1971.5909503065514427, 13731.693765509461125,
     45921.953931549871457, 67265.770927008700853, 33430.575583588128105, 2509.0809287301226727},
    {1.0, 42.313330701600911252, 687.1870074920579083, 5394.1960214247511077, 21213.794301586595867,
     39307.89580009271061, 28729.085735721942674, 5226.495278852545925}};

inline constexpr RatioOfPolynomials near_tail{
    {1.42343711074968357734, 4.6303378461565452959, 5.7694972214606914055, 3.64784832476320460504,
     1.27045825245236838258, 0.24178072517745061177, 0.0227238449892691845833, 7.7454501427834140764e-4},
    {1.0, 2.05319162663775882187, 1.6763848301838038494, 0.68976733498510000455, 0.14810397642748007459,
     0.0151986665636164571966, 5.475938084995344946e-4, 1.05075007164441684324e-9}};

inline constexpr RatioOfPolynomials far_tail{
    {6.6579046435011037772, 5.4637849111641143699, 1.7848265399172913358, 0.29656057182850489123,
     0.026532189526576123093, 0.0012426609473880784386, 2.71155556874348757815e-5, 2.01033439929228813265e-7},
    {1.0, 0.59983220655588793769, 0.13692988092273580531, 0.0148753612908506148525, 7.868691311456132591e-4,
     1.8463183175100546818e-5, 1.4215117583164458887e-7, 2.04426310338993978564e-15}};

}  // namespace detail

/// Quantile of the standard normal distribution, to 1e-16 relative (Wichura: The percentage points of the
/// normal distribution, Applied Statistics 37, 1988, algorithm AS 241).
inline double normal_quantile(double probability) {
  const double off_middle = probability - 0.5;
  if (std::abs(off_middle) <= 0.425) return off_middle * detail::central(0.180625 - off_middle * off_middle);
  const double r = std::sqrt(-portable_log(std::min(probability, 1.0 - probability)));
  const double size = r <= 5.0 ? detail::near_tail(r - 1.6) : detail::far_tail(r - 5.0);
  return off_middle < 0.0 ? -size : size;
}

}  // namespace stepwire
