#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// An estimate with its confidence interval (percentiles of a bootstrap).
struct Estimate {
  double value = 0.0;
  ConfidenceInterval interval;
};

/// Parameters of a bootstrap.
struct Bootstrap {
  double confidence = 0.95;
  std::size_t replicates = 500;
  std::int64_t seed = 1;
};

/// Samples of `width` numbers each. Samples with a non-finite number are left out.
struct Samples {
  std::vector<double> numbers;
  std::size_t width, count = 0;

  Samples(std::span<const double> all, std::size_t of_sample);
  const double* operator[](std::size_t sample) const { return numbers.data() + sample * width; }
};

/// Indices of drawn samples, with repetitions.
using Choice = std::vector<std::size_t>;

/// Computes numbers from samples, with their bootstrap intervals. Intervals are nan for fewer than two
/// samples.
std::vector<Estimate> estimate(const Samples& samples, const Bootstrap& bootstrap,
                               const std::function<std::vector<double>(const Choice&)>& numbers_of);

/// Returns the part-th group of `size` consecutive estimates.
std::vector<Estimate> part_of(const std::vector<Estimate>& all, std::size_t part, std::size_t size);

}  // namespace stepwire::statistics
