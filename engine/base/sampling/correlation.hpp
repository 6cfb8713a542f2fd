#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/base/sampling/design.hpp"

namespace stepwire::sampling {

/// The lower triangular factor of a matrix of correlations; nothing where it is not positive definite.
std::optional<Eigen::MatrixXd> correlation_factor(const Eigen::MatrixXd& correlations);

/// Correlates dimensions of points by a Gaussian copula: the normal scores of the points, multiplied by the
/// factor, have these correlations. Each dimension alone stays evenly distributed.
void correlate(Points& points, const Eigen::MatrixXd& factor);

}  // namespace stepwire::sampling
