#include "engine/analyse/comparison/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::comparison {

namespace {

void add(double value, ValueRange& range) {
  if (std::isnan(value)) {
    range.has_missing = true;
    return;
  }
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

}  // namespace

double same_instant(double last) {
  constexpr double rounding = 1e-10;  // of times that a file has with ten digits
  return rounding * std::abs(last);
}

RowGroup Sampling::group(double time) const {
  const auto& times = trace_.time;
  const auto begin = std::ranges::lower_bound(times, time - same_);
  const auto end = std::upper_bound(begin, times.end(), time + same_);
  return {static_cast<std::size_t>(begin - times.begin()), static_cast<std::size_t>(end - times.begin())};
}

double Sampling::between(double time, const RowGroup& at) const {
  if (at.begin == 0) return trace_.values.front();
  const std::size_t before = at.begin - 1;
  if (hold_ || at.begin == trace_.time.size()) return trace_.values[before];
  const double share = (time - trace_.time[before]) / (trace_.time[at.begin] - trace_.time[before]);
  return std::lerp(trace_.values[before], trace_.values[at.begin], share);
}

void Sampling::add_end(double time, ValueRange& range) const {
  if (time < trace_.time.front() || time > trace_.time.back()) return;
  const RowGroup at = group(time);
  if (at.size() == 0) return add(between(time, at), range);
  for (std::size_t row = at.begin; row < at.end; ++row) add(trace_.values[row], range);
}

ValueRange Sampling::range(double from, double to) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ValueRange range{infinity, -infinity};
  add_end(from, range);
  add_end(to, range);
  for (std::size_t row = group(from).begin; row < trace_.time.size() && trace_.time[row] <= to + same_; ++row)
    add(trace_.values[row], range);
  return range;
}

}  // namespace stepwire::comparison
