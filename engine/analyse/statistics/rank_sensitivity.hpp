#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/analyse/statistics/bootstrap.hpp"

namespace stepwire::statistics {

/// Monotonic dependence of an outcome on each parameter: -1 to 1, 0 for none.
struct RankSensitivity {
  std::vector<Estimate> rank;     ///< Spearman's rank correlation.
  std::vector<Estimate> partial;  ///< Rank correlation with the other parameters regressed out.
  std::size_t samples = 0;        ///< Number of complete samples.
};

/// Returns the least number of samples of a correlation from which the effect of `others` is removed. It
/// leaves two degrees of freedom: without one, each correlation is 1 or -1.
constexpr std::size_t fewest_rows(std::size_t others) {
  return others + 4;
}

/// Computes rank correlations (Spearman 1904) and partial ones (Iman and Conover 1979) for samples of any
/// design. A row of `rows` is one sample: the parameters, then the outcome. Samples with a non-finite number
/// are left out. The result is nan for a constant column, and for too few samples: see fewest_rows(). Partial
/// correlations are also nan if a parameter is a function of others.
RankSensitivity rank_sensitivity(std::span<const double> rows, std::size_t parameters,
                                 const Bootstrap& bootstrap);

}  // namespace stepwire::statistics
