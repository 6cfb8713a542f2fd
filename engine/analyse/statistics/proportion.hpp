#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Between which shares a probability lies of which `successes` of `count` independent trials tell, with at
/// least this confidence (Clopper and Pearson: The use of confidence or fiducial limits, Biometrika 26,
/// 1934). 0 to 1 without trials.
ConfidenceInterval proportion_interval(std::size_t successes, std::size_t count, double confidence);

/// Between which of `count` sorted independent values, from 0, the quantile of a share lies with at least
/// this confidence, whatever their distribution (order statistics). An end is none where so few values do not
/// tell.
struct RankInterval {
  std::optional<std::size_t> low, high;
};
RankInterval quantile_ranks(std::size_t count, double share, double confidence);

/// The fewest values for which both ends are there; for a share between 0 and 1.
std::size_t values_for_both_ranks(double share, double confidence);

}  // namespace stepwire::statistics
