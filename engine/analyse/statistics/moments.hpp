#pragma once

#include <vector>

namespace stepwire::statistics {

/// Mean of a sample and the squared deviations from it. They are computed from the differences from a
/// reference among the values, which keep the digits that a large mean would cost.
struct Moments {
  double above = 0.0;    ///< Mean minus the reference.
  double mean = 0.0;     ///< The mean, rounded once.
  double squares = 0.0;  ///< Sum of the squared differences from the mean.
};

/// Computes the moments of values; those of an empty list are NaN. Without a reference it is the first value.
Moments moments_of(const std::vector<double>& values);
Moments moments_of(const std::vector<double>& values, double reference);

}  // namespace stepwire::statistics
