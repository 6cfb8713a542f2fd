#include "engine/base/control/design.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "engine/base/control/control_fault.hpp"
#include "engine/base/control/riccati.hpp"
#include "engine/base/math/elementary.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::control {

namespace {

using Complex = std::complex<double>;

constexpr double limit_width = 1e-9, rank_tolerance = 1e-10;

/// Distance of an eigenvalue beyond the limit of stability; at least 0 where its mode is not stable.
double excess(const Complex& eigenvalue, Stability stability) {
  return stability == Stability::continuous ? eigenvalue.real() : std::abs(eigenvalue) - 1.0;
}

std::string shown(const Complex& eigenvalue) {
  if (eigenvalue.imag() == 0.0) return fmt::format("{:.6g}", eigenvalue.real());
  return fmt::format("{:.6g} {} {:.6g}i", eigenvalue.real(), eigenvalue.imag() < 0.0 ? "-" : "+",
                     std::abs(eigenvalue.imag()));
}

/// True where [A - s I, B] lacks full row rank, so that B does not reach the mode (Popov, Belevitch and
/// Hautus).
bool misses_mode(const Matrix& A, const Matrix& B, const Complex& eigenvalue) {
  Eigen::MatrixXcd pencil(A.rows(), A.cols() + B.cols());
  pencil << A.cast<Complex>(), B.cast<Complex>();
  for (Eigen::Index i = 0; i < A.rows(); ++i) pencil(i, i) -= eigenvalue;
  const Eigen::VectorXd singular = pencil.jacobiSvd().singularValues();
  return singular.minCoeff() <= rank_tolerance * singular.maxCoeff();
}

// Poles of a closed loop.

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::MatrixXcd;

/// Returns the poles: real ones first, then each pair with the positive imaginary part first.
std::vector<Complex> read_poles(const Matrix& poles, Eigen::Index order) {
  const bool is_list = poles.cols() == 1 || (poles.rows() == 1 && poles.cols() != 2);
  if ((is_list ? poles.size() : poles.rows()) != order || (!is_list && poles.cols() != 2))
    throw ControlFault(fmt::format("{}, and each has a pole: a list of {} real numbers, or {} rows [re, im]",
                                   text::there_are(order, "state"), order, order));
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
      mix[k] = fn::cos(1.0 + 2.0 * static_cast<double>(j * mix.size() + k));
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

std::string size_text(const Matrix& matrix) {
  return fmt::format("{} x {}", matrix.rows(), matrix.cols());
}

void require_size(const Matrix& matrix, Eigen::Index rows, Eigen::Index columns, const std::string& name) {
  if (matrix.rows() == rows && matrix.cols() == columns) return;
  throw ControlFault(fmt::format("{} is {}; {} x {} would fit", name, size_text(matrix), rows, columns));
}

void require_square(const Matrix& matrix, const std::string& name) {
  if (matrix.rows() != matrix.cols())
    throw ControlFault(fmt::format("{} is {}, and must be square", name, size_text(matrix)));
}

void require_weight(const Matrix& weight, bool definite, const std::string& name) {
  const double size = weight.cwiseAbs().maxCoeff();
  if ((weight - weight.transpose()).cwiseAbs().maxCoeff() > 1e-12 * size)
    throw ControlFault(fmt::format("the weight {} is not symmetric", name));
  const double least = Eigen::SelfAdjointEigenSolver<Matrix>(weight, Eigen::EigenvaluesOnly).eigenvalues()[0];
  if (definite ? !(least > 0.0) : !(least >= -1e-12 * size))
    throw ControlFault(fmt::format("the weight {} has the eigenvalue {:.6g}; all must be {} 0", name, least,
                                   definite ? "above" : "at least"));
}

Matrix inverse(const Matrix& matrix) {
  require_square(matrix, "what is inverted");
  const Eigen::PartialPivLU<Matrix> lu(matrix);
  if (!(lu.rcond() > 1e-15)) throw ControlFault("the matrix is singular and has no inverse");
  return lu.inverse();
}

void require_stabilizable(const Matrix& A, const Matrix& B, Stability stability) {
  for (const Complex& eigenvalue : A.eigenvalues())
    if (excess(eigenvalue, stability) >= -limit_width && misses_mode(A, B, eigenvalue))
      throw ControlFault(
          fmt::format("the system is not stabilizable: the mode with the eigenvalue {} is not stable, and no "
                      "input reaches it",
                      shown(eigenvalue)));
}

void require_weighed(const Matrix& A, const Matrix& Q, Stability stability) {
  for (const Complex& eigenvalue : A.eigenvalues())
    if (std::abs(excess(eigenvalue, stability)) <= limit_width &&
        misses_mode(A.transpose(), Q.transpose(), eigenvalue))
      throw ControlFault(fmt::format(
          "the mode with the eigenvalue {} is on the limit of stability and in no weight: nothing moves it",
          shown(eigenvalue)));
}

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
