#pragma once

#include <Eigen/Core>
#include <vector>

namespace stepwire::estimation {

/// The combinations of the unknowns that a Jacobian determines, with its columns scaled to length 1.
struct Resolution {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::VectorXd lengths;            ///< Of the columns.
  Eigen::MatrixXd scaled;             ///< The Jacobian over these lengths.
  Eigen::MatrixXd inverse;            ///< Of the scaled J' J, without the free directions.
  Eigen::VectorXd unknown;            ///< The largest part of each unknown in a free direction.
  std::vector<Eigen::VectorXd> free;  ///< Directions of the scaled unknowns along which all residuals keep.

  static Resolution of(const RowMajor& jacobian);
};

}  // namespace stepwire::estimation
