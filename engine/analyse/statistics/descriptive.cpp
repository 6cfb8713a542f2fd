#include "engine/analyse/statistics/descriptive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/analyse/statistics/no_number.hpp"

namespace stepwire::statistics {
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

bool has_nan(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  // The mean of n ranks, with or without ties.
  const double mean = 0.5 * (static_cast<double>(a.size()) + 1.0);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean) * (b[i] - mean);
    aa += (a[i] - mean) * (a[i] - mean);
    bb += (b[i] - mean) * (b[i] - mean);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace

Moments moments_of(const std::vector<double>& values) {
  return moments_of(values, values.empty() ? 0.0 : values.front());
}

Moments moments_of(const std::vector<double>& values, double reference) {
  if (values.empty()) return {no_number, no_number, no_number};
  const auto count = static_cast<double>(values.size());
  Moments moments;
  for (const double value : values) moments.above += value - reference;
  moments.above /= count;
  double left = 0.0;  // sum of the differences from the mean, 0 but for rounding
  for (const double value : values) {
    const double from_mean = (value - reference) - moments.above;
    left += from_mean;
    moments.squares += from_mean * from_mean;
  }
  moments.above += left / count;
  moments.squares -= left * left / count;
  moments.mean = reference + moments.above;
  return moments;
}

double hazen_quantile(const std::vector<double>& sorted, double p) {
  const double last = static_cast<double>(sorted.size() - 1);
  const double position = std::clamp(p * static_cast<double>(sorted.size()) - 0.5, 0.0, last);
  const auto below = static_cast<std::size_t>(position);
  const auto above = std::min(below + 1, sorted.size() - 1);
  const double part = position - static_cast<double>(below);
  return sorted[below] + part * (sorted[above] - sorted[below]);
}

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

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  std::vector<double> result(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    const double rank = 0.5 * static_cast<double>(first + 1 + end);
    for (; first < end; ++first) result[order[first]] = rank;
  }
  return result;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.size() < 2 || has_nan(a) || has_nan(b))
    return std::numeric_limits<double>::quiet_NaN();
  return correlation(ranks(a), ranks(b));
}

}  // namespace stepwire::statistics
