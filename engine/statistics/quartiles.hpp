#pragma once

#include <vector>

namespace stepwire {

/// Quantile of sorted values after Hazen: linear between the points ((i - 1/2)/n, x_i), i = 1..n; the ends
/// are held.
double hazen_quantile(const std::vector<double>& sorted, double p);

/// What a box plot shows of a sample: full range, quartiles after Hazen, median and mean.
struct BoxSummary {
  double min = 0.0, lower = 0.0, median = 0.0, upper = 0.0, max = 0.0, mean = 0.0;
};

/// The values need not be sorted; at least one is needed.
BoxSummary box_summary(std::vector<double> values);

}  // namespace stepwire
