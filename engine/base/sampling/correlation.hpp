#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/base/sampling/design.hpp"

namespace stepwire::sampling {

/// Returns the lower Cholesky factor of a correlation matrix; std::nullopt if that is not positive definite.
std::optional<Eigen::MatrixXd> correlation_factor(const Eigen::MatrixXd& correlations);

/// Correlates the dimensions of points by a Gaussian copula. The normal scores of the points, multiplied by
/// the factor, have these correlations. Each dimension alone stays uniform.
void correlate(Points& points, const Eigen::MatrixXd& factor);

}  // namespace stepwire::sampling
