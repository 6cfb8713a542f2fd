#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Returns the Clopper-Pearson confidence interval of a probability, from `successes` in `count` independent
/// trials (Clopper and Pearson: The use of confidence or fiducial limits, Biometrika 26, 1934). Without
/// trials it is 0 to 1.
ConfidenceInterval proportion_interval(std::size_t successes, std::size_t count, double confidence);

/// Distribution-free confidence interval of a quantile by order statistics. The ends are indices into `count`
/// sorted independent values. An end is std::nullopt if there are too few values.
struct RankInterval {
  std::optional<std::size_t> low, high;
};
RankInterval quantile_ranks(std::size_t count, double share, double confidence);

/// Returns the fewest values with which both ends exist; for a share between 0 and 1.
std::size_t values_for_both_ranks(double share, double confidence);

}  // namespace stepwire::statistics
