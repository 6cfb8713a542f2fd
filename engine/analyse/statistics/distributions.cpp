#include "engine/analyse/statistics/distributions.hpp"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/no_number.hpp"

namespace stepwire::statistics {
namespace {

constexpr double far_out = 40.0;
constexpr double largest_t = 1e4;  // beyond it Boost's series have too many terms

// Policy: a truncated series is exact enough; other errors give nan.
using Quietly = boost::math::policies::policy<
    boost::math::policies::domain_error<boost::math::policies::ignore_error>,
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;

double below_f(double f, double above, double below, double noncentrality) {
  if (noncentrality <= 0.0)  // Boost's noncentral F is slow at 0
    return boost::math::cdf(boost::math::fisher_f_distribution<double, Quietly>(above, below), f);
  return boost::math::cdf(
      boost::math::non_central_f_distribution<double, Quietly>(above, below, noncentrality), f);
}

/// Finds the root of a falling function that is positive at `low`; nan if it has none.
template <class Function>
double falling_root(Function function, double low, double step) {
  double high = low + step;
  for (int i = 0; function(high) > 0.0; ++i, step *= 2.0) {
    if (i == 60) return no_number;
    low = high, high += step;
  }
  std::uintmax_t most = 200;
  const auto ends = boost::math::tools::toms748_solve(function, low, high,
                                                      boost::math::tools::eps_tolerance<double>(48), most);
  return 0.5 * (ends.first + ends.second);
}

/// Returns the upper tail. A value slightly below zero (rounding of a sum of squares) counts as 0.
template <class Distribution>
double tail(const Distribution& distribution, double value) {
  if (std::isnan(value)) return value;
  if (std::isinf(value)) return 0.0;
  return boost::math::cdf(boost::math::complement(distribution, std::max(0.0, value)));
}

}  // namespace

double student_quantile(double probability, double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom), probability);
}

double noncentral_student_tail(double value, double freedom, double noncentrality) {
  // This far out the tail is 1 or 0 to the last digit, and Boost's term count would overflow an int.
  if (std::abs(noncentrality) > far_out * std::max(1.0, std::abs(value)))
    return noncentrality > 0.0 ? 1.0 : 0.0;
  const boost::math::non_central_t_distribution<double, Quietly> distribution(freedom, noncentrality);
  return boost::math::cdf(boost::math::complement(distribution, value));
}

ConfidenceInterval noncentrality_of_t(double t, double freedom) {
  if (!(std::abs(t) < largest_t) || !(freedom > 0.0)) return {no_number, no_number};
  const auto at = [&](double share) {
    const auto over = [&](double noncentrality) {
      return 1.0 - share - noncentral_student_tail(t, freedom, noncentrality);
    };
    double low = t - 1.0;
    for (double step = 1.0; over(low) <= 0.0; step *= 2.0) low -= step;
    return falling_root(over, low, 1.0);
  };
  return {at(0.975), at(0.025)};
}

ConfidenceInterval noncentrality_of_f(double f, double above, double below) {
  if (!(f * above < largest_t * largest_t) || !(above > 0.0) || !(below > 0.0)) return {no_number, no_number};
  const auto at = [&](double share) {
    const auto over = [&](double noncentrality) { return below_f(f, above, below, noncentrality) - share; };
    return over(0.0) <= 0.0 ? 0.0 : falling_root(over, 0.0, 1.0);
  };
  return {at(0.95), at(0.05)};
}

double fisher_tail(double value, double above, double below) {
  return tail(boost::math::fisher_f(above, below), value);
}

double fisher_critical(double probability, double above, double below) {
  return boost::math::quantile(boost::math::complement(boost::math::fisher_f(above, below), probability));
}

double chi_squared_tail(double value, double freedom) {
  return tail(boost::math::chi_squared(freedom), value);
}

double beta_quantile(double probability, double a, double b) {
  return boost::math::quantile(boost::math::beta_distribution<double>(a, b), probability);
}

double beta_tail(double value, double a, double b) {
  return boost::math::ibetac(a, b, value);
}

}  // namespace stepwire::statistics
