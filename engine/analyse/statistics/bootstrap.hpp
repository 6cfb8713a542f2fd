#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// An estimate, and between which numbers it lies when its samples are drawn again (percentiles of a
/// bootstrap).
struct Estimate {
  double value = 0.0;
  ConfidenceInterval interval;
};

/// How an interval of an estimate is found.
struct Bootstrap {
  double confidence = 0.95;
  std::size_t replicates = 500;
  std::int64_t seed = 1;
};

/// Samples, each as a row of as many numbers; those with one that is not finite are left out.
struct Samples {
  std::vector<double> numbers;
  std::size_t width, count = 0;

  Samples(std::span<const double> all, std::size_t of_sample);
  const double* operator[](std::size_t sample) const { return numbers.data() + sample * width; }
};

/// Some of the samples, by their numbers, some several times.
using Choice = std::vector<std::size_t>;

/// Numbers that are made of samples, with their intervals; none with fewer than two samples.
std::vector<Estimate> estimate(const Samples& samples, const Bootstrap& bootstrap,
                               const std::function<std::vector<double>(const Choice&)>& numbers_of);

/// So many estimates from the list of all, the part-th of such parts.
std::vector<Estimate> part_of(const std::vector<Estimate>& all, std::size_t part, std::size_t size);

}  // namespace stepwire::statistics
