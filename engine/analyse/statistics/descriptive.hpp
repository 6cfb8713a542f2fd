#pragma once

#include <vector>

namespace stepwire::statistics {

/// Mean of a sample and the squared deviations from it. They are computed from the differences from a
/// reference among the values, which keep the digits that a large mean would cost.
struct Moments {
  double above = 0.0;    ///< Mean minus the reference.
  double mean = 0.0;     ///< The mean, rounded once.
  double squares = 0.0;  ///< Sum of the squared differences from the mean.
};

/// Computes the moments of values; those of an empty list are NaN. Without a reference it is the first value.
Moments moments_of(const std::vector<double>& values);
Moments moments_of(const std::vector<double>& values, double reference);

/// Returns a quantile of sorted values (Hazen): linear between the points ((i - 1/2)/n, x_i), i = 1..n, and
/// constant beyond both ends.
double hazen_quantile(const std::vector<double>& sorted, double p);

/// Reach of the whiskers of a box: all values, or the last value within 1.5 interquartile ranges of the box
/// (Tukey 1977).
enum class Whiskers { range, tukey };

/// Numbers of a box plot: quartiles (Hazen), median, mean, ends of the whiskers, and the outliers beyond
/// them.
struct BoxSummary {
  double min = 0.0, lower = 0.0, median = 0.0, upper = 0.0, max = 0.0, mean = 0.0;
  double low_whisker = 0.0, high_whisker = 0.0;
  std::vector<double> beyond{};
};

/// Summarises values in any order; at least one is needed.
BoxSummary box_summary(std::vector<double> values, Whiskers whiskers = Whiskers::range);

/// Returns the ranks 1..n; equal values share the mean of their ranks.
std::vector<double> ranks(const std::vector<double>& values);

/// Returns Spearman's rank correlation, the correlation of the ranks. Nan for fewer than two values, for a
/// constant side, and for a nan among the values.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace stepwire::statistics
