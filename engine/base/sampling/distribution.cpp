#include "engine/base/sampling/distribution.hpp"

#include <cmath>
#include <numeric>

#include "engine/base/math/normal_quantile.hpp"

namespace stepwire::sampling {

namespace {

double triangular(const std::array<double, 3>& corners, double share) {
  const auto [low, mode, high] = corners;
  const double width = high - low, rise = (mode - low) / width;
  return share < rise ? low + std::sqrt(share * width * (mode - low))
                      : high - std::sqrt((1.0 - share) * width * (high - mode));
}

/// With the standard deviation s of the logarithm, the coefficient of variation is sqrt(exp(s^2) - 1).
double lognormal(double median, double variation, double share) {
  const double deviation = std::sqrt(portable_log(1.0 + variation * variation));
  return median * portable_exp(deviation * normal_quantile(share));
}

double word(const std::vector<double>& weights, double share) {
  double left = share * std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    if (left < weights[i]) return static_cast<double>(i);
    left -= weights[i];
  }
  return static_cast<double>(weights.size() - 1);
}

}  // namespace

double Distribution::quantile(double share) const {
  switch (kind) {
    case Kind::uniform:
      return numbers[0] + share * (numbers[1] - numbers[0]);
    case Kind::normal:
      return numbers[0] + numbers[1] * normal_quantile(share);
    case Kind::lognormal:
      return lognormal(numbers[0], numbers[1], share);
    case Kind::triangular:
      return triangular(numbers, share);
    case Kind::words:
      break;
  }
  return word(weights, share);
}

}  // namespace stepwire::sampling
