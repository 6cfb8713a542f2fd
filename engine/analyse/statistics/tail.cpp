#include "engine/analyse/statistics/tail.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

namespace stepwire::statistics {
namespace {

/// Returns the upper tail. A value slightly below zero (rounding of a sum of squares) counts as 0.
template <class Distribution>
double tail(const Distribution& distribution, double value) {
  if (std::isnan(value)) return value;
  if (std::isinf(value)) return 0.0;
  return boost::math::cdf(boost::math::complement(distribution, std::max(0.0, value)));
}

}  // namespace

double fisher_tail(double value, double above, double below) {
  return tail(boost::math::fisher_f(above, below), value);
}

double fisher_critical(double probability, double above, double below) {
  return boost::math::quantile(boost::math::complement(boost::math::fisher_f(above, below), probability));
}

double chi_squared_tail(double value, double freedom) {
  return tail(boost::math::chi_squared(freedom), value);
}

}  // namespace stepwire::statistics
