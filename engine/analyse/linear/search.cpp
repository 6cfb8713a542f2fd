#include "engine/analyse/linear/search.hpp"

#include <boost/math/tools/minima.hpp>
#include <limits>

namespace stepwire::linear {

double find_zero(const std::function<double(double)>& function, double low, double high) {
  const bool rises = function(low) < 0.0;
  for (int k = 0; k < 200 && high - low > 4e-16 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (((function(middle) < 0.0) == rises) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

CurvePoint find_minimum(const std::function<double(double)>& function, double low, double high) {
  // Shares of the interval: the accuracy of the method is absolute below 1.
  const auto at = [&](double share) { return low + share * (high - low); };
  const auto [share, least] = boost::math::tools::brent_find_minima(
      [&](double s) { return function(at(s)); }, 0.0, 1.0, std::numeric_limits<double>::digits / 2);
  return {at(share), least};
}

}  // namespace stepwire::linear
