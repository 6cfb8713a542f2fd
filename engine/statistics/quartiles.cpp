#include "engine/statistics/quartiles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stepwire {

double hazen_quantile(const std::vector<double>& sorted, double p) {
  const double last = static_cast<double>(sorted.size() - 1);
  const double position = std::clamp(p * static_cast<double>(sorted.size()) - 0.5, 0.0, last);
  const auto below = static_cast<std::size_t>(position);
  const auto above = std::min(below + 1, sorted.size() - 1);
  const double part = position - static_cast<double>(below);
  return sorted[below] + part * (sorted[above] - sorted[below]);
}

BoxSummary box_summary(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  BoxSummary box;
  box.min = values.front();
  box.lower = hazen_quantile(values, 0.25);
  box.median = hazen_quantile(values, 0.5);
  box.upper = hazen_quantile(values, 0.75);
  box.max = values.back();
  box.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return box;
}

}  // namespace stepwire
