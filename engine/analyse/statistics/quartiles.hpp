#pragma once

#include <vector>

namespace stepwire::statistics {

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

}  // namespace stepwire::statistics
