#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/analyse/statistics/bootstrap.hpp"

namespace stepwire::statistics {

/// How an outcome goes up or down with each parameter: between -1 and 1, 0 where it does neither.
struct RankSensitivity {
  std::vector<Estimate> rank;     ///< Spearman's rank correlation
  std::vector<Estimate> partial;  ///< that of what the ranks of the other parameters do not explain
  std::size_t samples = 0;        ///< that count
};

/// Rank correlations (Spearman 1904) and partial ones (Iman and Conover 1979) from samples of any design:
/// the values of all parameters, and the outcome behind them, a row for each sample. One with a number that
/// is none does not count. nan with fewer than two, and where a column has one value; partial ones also where
/// a parameter follows from others.
RankSensitivity rank_sensitivity(std::span<const double> rows, std::size_t parameters,
                                 const Bootstrap& bootstrap);

}  // namespace stepwire::statistics
