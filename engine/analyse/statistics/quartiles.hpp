#pragma once

#include <vector>

namespace stepwire::statistics {

/// Quantile of sorted values after Hazen: linear between the points ((i - 1/2)/n, x_i), i = 1..n; the ends
/// are held.
double hazen_quantile(const std::vector<double>& sorted, double p);

/// How far the whiskers of a box reach: over all values, or to the last value within 1.5 interquartile ranges
/// of the box (Tukey 1977).
enum class Whiskers { range, tukey };

/// What a box plot shows of a sample: quartiles after Hazen, median, mean, the ends of the whiskers, and the
/// values beyond them.
struct BoxSummary {
  double min = 0.0, lower = 0.0, median = 0.0, upper = 0.0, max = 0.0, mean = 0.0;
  double low_whisker = 0.0, high_whisker = 0.0;
  std::vector<double> beyond{};
};

/// The values need not be sorted; at least one is needed.
BoxSummary box_summary(std::vector<double> values, Whiskers whiskers = Whiskers::range);

}  // namespace stepwire::statistics
