#pragma once

#include <Eigen/Core>
#include <vector>

namespace stepwire::estimation {

/// The combinations of the unknowns that a Jacobian determines, with its columns scaled to length 1.
struct Resolution {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::VectorXd lengths;            ///< of the columns
  Eigen::MatrixXd scaled;             ///< the Jacobian over these lengths
  Eigen::MatrixXd inverse;            ///< of the scaled J' J, the free directions left out
  Eigen::VectorXd unknown;            ///< the largest part of each unknown in a free direction
  std::vector<Eigen::VectorXd> free;  ///< directions of the scaled unknowns that change nothing

  static Resolution of(const RowMajor& jacobian);
};

}  // namespace stepwire::estimation
