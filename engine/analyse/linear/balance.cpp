#include "engine/analyse/linear/balance.hpp"

#include <cmath>

namespace stepwire::linear {

namespace {

/// Returns the power of two nearest to the root of row / column.
double factor_of(double row, double column) {
  return std::exp2(std::round(0.5 * std::log2(row / column)));
}

/// Scales one state. Returns false, without scaling, if the norms would fall by less than 5 %.
bool scale_one(Eigen::MatrixXd& A, Eigen::Index i, Eigen::VectorXd& scale) {
  const double own = std::abs(A(i, i));
  const double row = A.row(i).cwiseAbs().sum() - own, column = A.col(i).cwiseAbs().sum() - own;
  if (!(row > 0.0 && column > 0.0)) return false;
  const double factor = factor_of(row, column);
  if (!(column * factor + row / factor < 0.95 * (column + row))) return false;
  scale[i] *= factor;
  A.row(i) /= factor;
  A.col(i) *= factor;
  return true;
}

}  // namespace

Eigen::VectorXd balancing(Eigen::MatrixXd A) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(A.rows());
  bool again = true;
  for (int sweep = 0; again && sweep < 100; ++sweep) {
    again = false;
    for (Eigen::Index i = 0; i < A.rows(); ++i) again = scale_one(A, i, scale) || again;
  }
  return scale;
}

}  // namespace stepwire::linear
