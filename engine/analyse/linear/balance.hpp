#pragma once

#include <Eigen/Core>

namespace stepwire::linear {

/// Powers of two by which states are scaled (x = scale z) so that rows and columns of A are alike, which
/// leaves its eigenvalues as they are. B. N. Parlett, C. Reinsch, "Balancing a matrix for calculation of
/// eigenvalues and eigenvectors", 1969.
Eigen::VectorXd balancing(Eigen::MatrixXd A);

}  // namespace stepwire::linear
