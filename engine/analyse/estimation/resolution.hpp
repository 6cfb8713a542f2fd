#pragma once

#include <Eigen/Core>
#include <vector>

namespace stepwire::estimation {

/// Combinations of the unknowns that a Jacobian determines, with its columns scaled to length 1.
struct Resolution {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::VectorXd lengths;            ///< Lengths of the columns.
  Eigen::MatrixXd scaled;             ///< The Jacobian divided by these lengths.
  Eigen::MatrixXd inverse;            ///< Inverse of the scaled J' J, without the free directions.
  Eigen::VectorXd unknown;            ///< Largest component of each unknown in a free direction.
  std::vector<Eigen::VectorXd> free;  ///< Directions of the scaled unknowns that change no residual.

  static Resolution of(const RowMajor& jacobian);
};

}  // namespace stepwire::estimation
