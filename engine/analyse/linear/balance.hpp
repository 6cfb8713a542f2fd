#pragma once

#include <Eigen/Core>

namespace stepwire::linear {

/// Returns powers of two that scale the states (x = scale z) so that rows and columns of A have similar
/// norms. Eigenvalues are unchanged. B. N. Parlett, C. Reinsch, "Balancing a matrix for calculation of
/// eigenvalues and eigenvectors", 1969.
Eigen::VectorXd balancing(Eigen::MatrixXd A);

}  // namespace stepwire::linear
