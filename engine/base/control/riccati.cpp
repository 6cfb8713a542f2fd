#include "engine/base/control/riccati.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>

#include "engine/base/control/control_fault.hpp"
#include "engine/base/math/elementary.hpp"

namespace stepwire::control {

namespace {

constexpr int most_iterations = 100;

[[noreturn]] void give_up() {
  throw ControlFault(
      "no solution is found: the system and its weights are too near to one that is not stabilizable");
}

void check(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R, Stability stability) {
  require_square(A, "A");
  require_size(B, A.rows(), B.cols(), "B");
  require_size(Q, A.rows(), A.rows(), "Q");
  require_size(R, B.cols(), B.cols(), "R");
  require_weight(Q, false, "Q");
  require_weight(R, true, "R");
  require_stabilizable(A, B, stability);
  require_weighed(A, Q, stability);
}

Matrix symmetric(const Matrix& X) {
  return 0.5 * (X + X.transpose());
}

/// Returns log |det|; the determinant itself may overflow a double.
double log_determinant(const Eigen::PartialPivLU<Matrix>& lu) {
  return lu.matrixLU().diagonal().cwiseAbs().array().log().sum();
}

Matrix matrix_sign(Matrix Z) {
  for (int k = 0; k < most_iterations; ++k) {
    const Eigen::PartialPivLU<Matrix> lu(Z);
    const double scale = fn::exp(-log_determinant(lu) / static_cast<double>(Z.rows()));
    if (!std::isfinite(scale) || scale == 0.0) give_up();
    const bool is_near = k > 0 && std::abs(scale - 1.0) < 1e-2;
    const double by = is_near ? 1.0 : scale;
    const Matrix next = 0.5 * (by * Z + lu.inverse() / by);
    const double change = (next - Z).norm() / next.norm();
    Z = next;
    if (!Z.allFinite()) give_up();
    if (change < 1e-13) return Z;
  }
  return Z;  // converged to rounding; the callers check the result
}

Matrix stabilizing_start(const Matrix& A, const Matrix& G, const Matrix& Q) {
  const Eigen::Index n = A.rows();
  Matrix H(2 * n, 2 * n), left(2 * n, n), right(2 * n, n);
  H << A, -G, -Q, -A.transpose();
  const Matrix S = matrix_sign(H), one = Matrix::Identity(n, n);
  left << S.topRightCorner(n, n), S.bottomRightCorner(n, n) + one;
  right << S.topLeftCorner(n, n) + one, S.bottomLeftCorner(n, n);
  return symmetric(left.colPivHouseholderQr().solve(-right));
}

bool is_stable(const Matrix& A, Stability stability) {
  for (const std::complex<double>& eigenvalue : A.eigenvalues())
    if (!(stability == Stability::continuous ? eigenvalue.real() < 0.0 : std::abs(eigenvalue) < 1.0))
      return false;
  return A.allFinite();
}

}  // namespace

Matrix lyapunov(const Matrix& A, const Matrix& W) {
  const Eigen::ComplexSchur<Matrix> schur(A);
  const Eigen::MatrixXcd &U = schur.matrixU(), &T = schur.matrixT();
  const Eigen::MatrixXcd F = U.adjoint() * W.cast<std::complex<double>>() * U;
  Eigen::MatrixXcd Y = Eigen::MatrixXcd::Zero(A.rows(), A.cols());
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    Eigen::MatrixXcd L = T.adjoint();
    L.diagonal().array() += T(k, k);
    const Eigen::VectorXcd known = -F.col(k) - Y.leftCols(k) * T.col(k).head(k);
    Y.col(k) = L.triangularView<Eigen::Lower>().solve(known);
  }
  return symmetric((U * Y * U.adjoint()).real());
}

Matrix continuous_riccati(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R) {
  check(A, B, Q, R, Stability::continuous);
  const Matrix R_inverse = R.ldlt().solve(Matrix::Identity(R.rows(), R.cols()));
  const Matrix G = symmetric(B * R_inverse * B.transpose());
  Matrix X = stabilizing_start(A, G, Q);
  for (int k = 0; k < 3; ++k) {
    const Matrix closed = A - G * X;
    if (!is_stable(closed, Stability::continuous)) give_up();
    X = lyapunov(closed, symmetric(Q + X * G * X));
  }
  return X;
}

Matrix sampled_riccati(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R) {
  check(A, B, Q, R, Stability::sampled);
  const Eigen::Index n = A.rows();
  const Matrix one = Matrix::Identity(n, n);
  Matrix Ak = A, G = symmetric(B * R.ldlt().solve(B.transpose())), X = Q;
  for (int k = 0; k < most_iterations; ++k) {
    const Eigen::PartialPivLU<Matrix> W(one + G * X);
    const Matrix WA = W.solve(Ak), WG = W.solve(G);
    const Matrix next = symmetric(X + Ak.transpose() * X * WA);
    G = symmetric(G + Ak * WG * Ak.transpose());
    Ak = Ak * WA;
    const double change = (next - X).norm();
    X = next;
    if (!X.allFinite()) give_up();
    if (change <= 1e-15 * X.norm()) break;
  }
  const Matrix K = (R + B.transpose() * X * B).ldlt().solve(B.transpose() * X * A);
  if (!is_stable(A - B * K, Stability::sampled)) give_up();
  return X;
}

}  // namespace stepwire::control
