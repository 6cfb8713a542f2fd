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

/// Computes rank correlations (Spearman 1904) and partial ones (Iman and Conover 1979) for samples of any
/// design. A row of `rows` is one sample: the parameters, then the outcome. Samples with a non-finite number
/// are left out. The result is nan for fewer than two samples and for a constant column. Partial correlations
/// are also nan if a parameter is a function of others.
RankSensitivity rank_sensitivity(std::span<const double> rows, std::size_t parameters,
                                 const Bootstrap& bootstrap);

}  // namespace stepwire::statistics
