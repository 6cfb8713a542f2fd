#include "engine/analyse/statistics/quartiles.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/moments.hpp"

namespace stepwire::statistics {

double hazen_quantile(const std::vector<double>& sorted, double p) {
  const double last = static_cast<double>(sorted.size() - 1);
  const double position = std::clamp(p * static_cast<double>(sorted.size()) - 0.5, 0.0, last);
  const auto below = static_cast<std::size_t>(position);
  const auto above = std::min(below + 1, sorted.size() - 1);
  const double part = position - static_cast<double>(below);
  return sorted[below] + part * (sorted[above] - sorted[below]);
}

namespace {

/// Shortens the whiskers to the last value within reach, or to the edge of the box if there is none outside
/// it.
void shorten_whiskers(BoxSummary& box, const std::vector<double>& sorted) {
  const double reach = 1.5 * (box.upper - box.lower);
  box.low_whisker = box.lower;
  box.high_whisker = box.upper;
  for (const double value : sorted) {
    if (value < box.lower - reach || value > box.upper + reach) {
      box.beyond.push_back(value);
      continue;
    }
    box.low_whisker = std::min(box.low_whisker, value);
    box.high_whisker = std::max(box.high_whisker, value);
  }
}

}  // namespace

BoxSummary box_summary(std::vector<double> values, Whiskers whiskers) {
  std::sort(values.begin(), values.end());
  BoxSummary box;
  box.min = box.low_whisker = values.front();
  box.lower = hazen_quantile(values, 0.25);
  box.median = hazen_quantile(values, 0.5);
  box.upper = hazen_quantile(values, 0.75);
  box.max = box.high_whisker = values.back();
  box.mean = moments_of(values).mean;
  if (whiskers == Whiskers::tukey) shorten_whiskers(box, values);
  return box;
}

}  // namespace stepwire::statistics
