#include "engine/base/sampling/correlation.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/math/normal_quantile.hpp"

namespace stepwire::sampling {

// Written by hand: Eigen orders its operations by the target machine, which would change bits.
std::optional<Eigen::MatrixXd> correlation_factor(const Eigen::MatrixXd& correlations) {
  const Eigen::Index n = correlations.rows();
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index row = 0; row < n; ++row)
    for (Eigen::Index column = 0; column <= row; ++column) {
      double rest = correlations(row, column);
      for (Eigen::Index k = 0; k < column; ++k) rest -= factor(row, k) * factor(column, k);
      if (row == column && !(rest > 1e-12)) return std::nullopt;
      factor(row, column) = row == column ? std::sqrt(rest) : rest / factor(column, column);
    }
  return factor;
}

void correlate(Points& points, const Eigen::MatrixXd& factor) {
  const std::size_t dimensions = points.size();
  std::vector<double> scores(dimensions);
  for (std::size_t i = 0; dimensions > 0 && i < points.front().size(); ++i) {
    for (std::size_t d = 0; d < dimensions; ++d) scores[d] = normal_quantile(points[d][i]);
    for (std::size_t d = 0; d < dimensions; ++d) {
      const auto row = static_cast<Eigen::Index>(d);
      if (factor(row, row) == 1.0) continue;  // uncorrelated with all earlier ones; stays unchanged
      double score = 0.0;
      for (std::size_t k = 0; k <= d; ++k) score += factor(row, static_cast<Eigen::Index>(k)) * scores[k];
      points[d][i] = std::clamp(normal_probability(score), 0x1.0p-53, 1.0 - 0x1.0p-53);
    }
  }
}

}  // namespace stepwire::sampling
