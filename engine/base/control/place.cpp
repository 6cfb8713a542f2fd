// Poles of a closed loop.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "engine/base/control/design.hpp"
#include "engine/base/control/control_fault.hpp"

namespace stepwire::control {

namespace {

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::MatrixXcd;

/// Returns the poles: real ones first, then each pair with the positive imaginary part first.
std::vector<Complex> read_poles(const Matrix& poles, Eigen::Index order) {
  const bool is_list = poles.cols() == 1 || (poles.rows() == 1 && poles.cols() != 2);
  if ((is_list ? poles.size() : poles.rows()) != order || (!is_list && poles.cols() != 2))
    throw ControlFault(
        fmt::format("there are {} states, and each has a pole: a list of {} real numbers, or {} "
                    "rows [re, im]",
                    order, order, order));
  std::vector<Complex> real, pairs, below;
  for (Eigen::Index i = 0; i < order; ++i) {
    const Complex pole = is_list ? Complex(poles.reshaped()[i]) : Complex(poles(i, 0), poles(i, 1));
    (pole.imag() == 0.0 ? real : pole.imag() > 0.0 ? pairs : below).push_back(pole);
  }
  for (const Complex& pole : pairs) {
    const auto other = std::find(below.begin(), below.end(), std::conj(pole));
    if (other == below.end()) break;
    below.erase(other);
    real.push_back(pole);
    real.push_back(std::conj(pole));
  }
  if (static_cast<Eigen::Index>(real.size()) != order || !below.empty())
    throw ControlFault("complex poles stand in pairs, [re, im] and [re, -im]");
  return real;
}

/// Returns the unique gain for one input by Ackermann's formula, which also allows repeated poles.
Matrix ackermann(const Matrix& A, const Matrix& b, const std::vector<Complex>& poles) {
  const Eigen::Index n = A.rows();
  Matrix reached(n, n);
  reached.col(0) = b;
  for (Eigen::Index k = 1; k < n; ++k) reached.col(k) = A * reached.col(k - 1);
  ComplexMatrix product = ComplexMatrix::Identity(n, n);
  for (const Complex& pole : poles)
    product = product * (A.cast<Complex>() - pole * ComplexMatrix::Identity(n, n));
  const Eigen::VectorXd last = Eigen::VectorXd::Unit(n, n - 1);
  return reached.transpose().fullPivLu().solve(last).transpose() * product.real();
}

/// Returns a basis of the eigenvectors that a pole may have: the kernel of U1'(A - pole I). U1 spans the
/// complement of the range of B.
ComplexMatrix eigenvectors_of(const Matrix& A, const Matrix& U1, const Complex& pole) {
  const Eigen::Index n = A.rows();
  const ComplexMatrix held =
      (U1.transpose().cast<Complex>() * (A.cast<Complex>() - pole * ComplexMatrix::Identity(n, n))).adjoint();
  const ComplexMatrix Q = held.householderQr().householderQ();
  return Q.rightCols(n - U1.cols());
}

/// Chooses eigenvectors of the closed loop for several inputs (Kautsky, Nichols and Van Dooren 1985, method
/// 0). Each pole leaves a subspace of possible eigenvectors. The more orthogonal the chosen ones are, the
/// less the poles react to errors of A and B. The iteration replaces one vector at a time by the projection
/// of the normal of all others onto its subspace.
class Placement {
 public:
  Placement(const Matrix& A, const Matrix& U1, const std::vector<Complex>& poles)
      : poles_(poles), X_(A.rows(), A.rows()) {
    for (const Complex& pole : poles) kernels_.push_back(eigenvectors_of(A, U1, pole));
    for (Eigen::Index j = 0; j < A.rows(); ++j) start(j);
  }

  /// Turns each eigenvector as far from the others as its kernel allows, until their volume stops growing.
  const ComplexMatrix& run() {
    double volume = std::abs(X_.determinant());
    for (int sweep = 0; sweep < 100; ++sweep) {
      for (Eigen::Index j = 0; j < X_.cols(); ++j)
        if (poles_[static_cast<std::size_t>(j)].imag() >= 0.0) turn(j);
      const double grown = std::abs(X_.determinant());
      if (std::abs(grown - volume) <= 1e-6 * grown) break;
      volume = grown;
    }
    return X_;
  }

 private:
  const ComplexMatrix& kernel(Eigen::Index j) const { return kernels_[static_cast<std::size_t>(j)]; }

  void set(Eigen::Index j, const Eigen::VectorXcd& x) {
    X_.col(j) = x;
    if (poles_[static_cast<std::size_t>(j)].imag() > 0.0) X_.col(j + 1) = x.conjugate();
  }

  /// Sets an initial eigenvector that differs from those of the same pole.
  void start(Eigen::Index j) {
    if (poles_[static_cast<std::size_t>(j)].imag() < 0.0) return;
    Eigen::VectorXcd mix(kernel(j).cols());
    for (Eigen::Index k = 0; k < mix.size(); ++k)
      mix[k] = std::cos(1.0 + 2.0 * static_cast<double>(j * mix.size() + k));
    Eigen::VectorXcd x = kernel(j) * mix;
    if (poles_[static_cast<std::size_t>(j)].imag() == 0.0) x = x.real().eval().cast<Complex>();
    set(j, x.normalized());
  }

  void turn(Eigen::Index j) {
    const Eigen::Index n = X_.cols();
    ComplexMatrix others(n, n - 1);
    others << X_.leftCols(j), X_.rightCols(n - 1 - j);
    const ComplexMatrix Q = others.householderQr().householderQ();
    const Eigen::VectorXcd x = kernel(j) * (kernel(j).adjoint() * Q.col(n - 1));
    if (x.norm() > 1e-12) set(j, x.normalized());
  }

  const std::vector<Complex>& poles_;
  std::vector<ComplexMatrix> kernels_;
  ComplexMatrix X_;
};

/// Returns the closed loop with these eigenvalues and eigenvectors.
Matrix closed_loop(const ComplexMatrix& X, const std::vector<Complex>& poles) {
  const Eigen::VectorXcd values = Eigen::Map<const Eigen::VectorXcd>(poles.data(), X.cols());
  const ComplexMatrix product = X * values.asDiagonal();
  return X.transpose().fullPivLu().solve(product.transpose()).transpose().real();
}

/// Returns a closed loop with these poles. It is reachable because every state has an input of its own.
Matrix diagonal_loop(const std::vector<Complex>& poles) {
  const auto n = static_cast<Eigen::Index>(poles.size());
  Matrix M = Matrix::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Complex& pole = poles[static_cast<std::size_t>(i)];
    M(i, i) = pole.real();
    if (pole.imag() > 0.0) M(i, i + 1) = pole.imag();
    if (pole.imag() < 0.0) M(i, i - 1) = pole.imag();
  }
  return M;
}

/// Throws ControlFault where the poles of the closed loop differ from the given ones.
void check_poles(const Matrix& closed, const std::vector<Complex>& poles) {
  std::vector<Complex> left = poles;
  double scale = 1.0, worst = 0.0;
  for (const Complex& pole : poles) scale = std::max(scale, std::abs(pole));
  const Eigen::VectorXcd eigenvalues = closed.eigenvalues();
  for (Eigen::Index i = 0; i < eigenvalues.size(); ++i) {
    const auto nearest = std::min_element(left.begin(), left.end(), [&](const Complex& a, const Complex& b) {
      return std::abs(a - eigenvalues[i]) < std::abs(b - eigenvalues[i]);
    });
    worst = std::max(worst, std::abs(*nearest - eigenvalues[i]));
    left.erase(nearest);
  }
  if (!closed.allFinite() || !(worst <= 1e-2 * scale))
    throw ControlFault("the poles cannot be placed: the system is not controllable, or nearly so");
}

Eigen::Index most_equal(const std::vector<Complex>& poles) {
  std::ptrdiff_t most = 0;
  for (const Complex& pole : poles) most = std::max(most, std::count(poles.begin(), poles.end(), pole));
  return most;
}

}  // namespace

Matrix place(const Matrix& A, const Matrix& B, const Matrix& poles) {
  require_square(A, "A");
  require_size(B, A.rows(), B.cols(), "B");
  const std::vector<Complex> wanted = read_poles(poles, A.rows());
  const Eigen::ColPivHouseholderQR<Matrix> reached(B);
  const Eigen::Index n = A.rows(), rank = reached.rank();
  if (rank == 0) throw ControlFault("the poles cannot be placed: B is zero");
  if (rank < n && most_equal(wanted) > rank && B.cols() > 1)
    throw ControlFault(
        fmt::format("a pole stands {} times; with {} inputs that act apart it may stand as often "
                    "as there are of these",
                    most_equal(wanted), rank));
  Matrix K;
  if (B.cols() == 1) {
    K = ackermann(A, B, wanted);
  } else if (rank == n) {
    K = B.colPivHouseholderQr().solve(A - diagonal_loop(wanted));
  } else {
    const Matrix Q = reached.householderQ();
    const Matrix U1 = Q.rightCols(n - rank);
    K = B.completeOrthogonalDecomposition().solve(A - closed_loop(Placement(A, U1, wanted).run(), wanted));
  }
  check_poles(A - B * K, wanted);
  return K;
}

}  // namespace stepwire::control
