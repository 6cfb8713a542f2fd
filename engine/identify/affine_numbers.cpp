#include "engine/identify/affine_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire {

namespace {

constexpr double rounding = 1e-9;  // relative; what no straight line would explain is far above it

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

AffineNumbers::AffineNumbers(std::vector<double> start_values, std::vector<double> at_start,
                             const std::vector<double>& origin, const std::vector<Probe>& probes)
    : start_values_(std::move(start_values)), at_start_(std::move(at_start)) {
  for (std::size_t i = 0; i < std::min(origin.size(), at_start_.size()); ++i) {
    const bool moves = std::any_of(probes.begin(), probes.end(),
                                   [&](const Probe& probe) { return !same(probe.numbers[i], origin[i]); });
    if (!moves) continue;
    Moving moving{i, {}};
    for (const Probe& probe : probes)
      moving.slopes.push_back(
          same(probe.numbers[i], origin[i]) ? 0.0 : (probe.numbers[i] - origin[i]) / probe.change);
    moving_.push_back(std::move(moving));
  }
}

std::vector<double> AffineNumbers::at(const std::vector<double>& values) const {
  std::vector<double> numbers = at_start_;
  for (const Moving& moving : moving_)
    for (std::size_t j = 0; j < values.size(); ++j)
      if (moving.slopes[j] != 0.0) numbers[moving.place] += moving.slopes[j] * (values[j] - start_values_[j]);
  return numbers;
}

bool AffineNumbers::agrees(const std::vector<double>& values, const std::vector<double>& numbers) const {
  if (numbers.size() != at_start_.size()) return false;
  const std::vector<double> expected = at(values);
  std::vector<double> size(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) size[i] = std::abs(numbers[i]) + std::abs(at_start_[i]);
  for (const Moving& moving : moving_)
    for (std::size_t j = 0; j < values.size(); ++j)
      size[moving.place] += std::abs(moving.slopes[j] * (values[j] - start_values_[j]));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!same(expected[i], numbers[i]) && !(std::abs(expected[i] - numbers[i]) <= rounding * size[i]))
      return false;
  return true;
}

}  // namespace stepwire
