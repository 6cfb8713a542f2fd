#include "engine/base/control/system_check.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <complex>

#include "engine/base/control/control_fault.hpp"

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

}  // namespace stepwire::control
