#include "engine/analyse/statistics/moments.hpp"

#include "engine/analyse/statistics/no_number.hpp"

namespace stepwire::statistics {

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

}  // namespace stepwire::statistics
