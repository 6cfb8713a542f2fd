#include "engine/base/control/design.hpp"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "engine/base/control/control_fault.hpp"
#include "engine/base/control/riccati.hpp"

namespace stepwire::control {

Matrix lqr(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R) {
  return R.ldlt().solve(B.transpose() * continuous_riccati(A, B, Q, R));
}

Matrix dlqr(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R) {
  const Matrix X = sampled_riccati(A, B, Q, R);
  return (R + B.transpose() * X * B).ldlt().solve(B.transpose() * X * A);
}

Matrix kalman(const Matrix& A, const Matrix& C, const Matrix& Q, const Matrix& R) {
  return lqr(A.transpose(), C.transpose(), Q, R).transpose();
}

Matrix dkalman(const Matrix& A, const Matrix& C, const Matrix& Q, const Matrix& R) {
  const Matrix P = sampled_riccati(A.transpose(), C.transpose(), Q, R);
  return (C * P * C.transpose() + R).ldlt().solve(C * P).transpose();
}

Matrix exponential(const Matrix& A) {
  require_square(A, "what is exponentiated");
  return A.exp();
}

Matrix sampled_A(const Matrix& A, double T) {
  return exponential(A * T);
}

Matrix sampled_B(const Matrix& A, const Matrix& B, double T) {
  require_square(A, "A");
  require_size(B, A.rows(), B.cols(), "B");
  const Eigen::Index n = A.rows(), m = B.cols();
  Matrix both = Matrix::Zero(n + m, n + m);
  both << A * T, B * T, Matrix::Zero(m, n + m);
  return exponential(both).topRightCorner(n, m);
}

}  // namespace stepwire::control
