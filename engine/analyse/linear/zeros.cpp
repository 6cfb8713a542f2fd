#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>

#include "engine/analyse/linear/balance.hpp"
#include "engine/analyse/linear/poles.hpp"

namespace stepwire::linear {

namespace {

constexpr double rank_tolerance = 1e-11;  // of matrices whose rows and columns are near 1

struct Matrices {
  Eigen::MatrixXd A, B, C, D;

  Matrices transposed() const { return {A.transpose(), C.transpose(), B.transpose(), D.transpose()}; }
};

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd>;

Eigen::Index rank_of(const Svd& svd) {
  return (svd.singularValues().array() > rank_tolerance).count();
}

Eigen::MatrixXd stacked(const Eigen::MatrixXd& upper, const Eigen::MatrixXd& lower) {
  Eigen::MatrixXd both(upper.rows() + lower.rows(), upper.cols());
  both << upper, lower;
  return both;
}

/// Scales states, time, inputs and outputs so that the numbers are near 1; returns the scale of time.
double scale(Matrices& m) {
  const Eigen::VectorXd states = balancing(m.A);
  m.A = states.cwiseInverse().asDiagonal() * m.A * states.asDiagonal();
  m.B = states.cwiseInverse().asDiagonal() * m.B;
  m.C = m.C * states.asDiagonal();
  const double time = std::max(m.A.cwiseAbs().maxCoeff(), 1e-300);
  m.A /= time;
  for (Eigen::Index i = 0; i < m.B.cols(); ++i)
    if (const double size = std::max(m.B.col(i).norm(), m.D.col(i).norm()); size > 0.0) {
      m.B.col(i) /= size;
      m.D.col(i) /= size;
    }
  for (Eigen::Index i = 0; i < m.C.rows(); ++i)
    if (const double size = std::max(m.C.row(i).norm(), m.D.row(i).norm()); size > 0.0) {
      m.C.row(i) /= size;
      m.D.row(i) /= size;
    }
  return time;
}

/// By what a matrix is turned so that its rows beyond its rank are 0.
struct Turned {
  Eigen::MatrixXd turn;
  Eigen::Index rank = 0;
};

Turned turned_rows(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return {Eigen::MatrixXd::Identity(matrix.rows(), matrix.rows())};
  const Svd svd(matrix, Eigen::ComputeFullU);
  return {svd.matrixU().transpose(), rank_of(svd)};
}

/// Takes outputs away that are no combination of others at once, with the states that they fix, until D has
/// full row rank.
Matrices with_full_rows(Matrices m) {
  while (m.C.rows() > 0) {
    const Turned rows = turned_rows(m.D);
    const Eigen::Index rank = rows.rank, lower = m.C.rows() - rank;
    if (lower == 0) break;
    const Eigen::MatrixXd C = rows.turn * m.C;
    m.D = (rows.turn * m.D).topRows(rank).eval();
    m.C = C.topRows(rank);
    const Eigen::Index n = m.A.rows();
    if (n == 0) break;
    const Svd columns(C.bottomRows(lower), Eigen::ComputeFullV);
    const Eigen::Index fixed = rank_of(columns);
    if (fixed == 0) break;
    // The first of these states are fixed by the outputs, the others stay free.
    const Eigen::MatrixXd& V = columns.matrixV();
    const Eigen::MatrixXd A = V.transpose() * m.A * V, B = V.transpose() * m.B, C1 = m.C * V;
    m.C = stacked(C1.rightCols(n - fixed), A.topRightCorner(fixed, n - fixed));
    m.D = stacked(m.D, B.topRows(fixed));
    m.A = A.bottomRightCorner(n - fixed, n - fixed);
    m.B = B.bottomRows(n - fixed);
  }
  return m;
}

}  // namespace

std::vector<Complex> zeros_of(const StateSpace& system) {
  if (system.A.size() == 0 || system.B.size() == 0 || system.C.size() == 0) return {};
  Matrices m{system.A, system.B, system.C, system.D};
  const double time = scale(m);
  m = with_full_rows(with_full_rows(std::move(m)).transposed()).transposed();
  if (m.A.rows() == 0) return {};
  Eigen::MatrixXd free = m.A;
  if (m.D.size() > 0) free -= m.B * m.D.colPivHouseholderQr().solve(m.C);
  std::vector<Complex> zeros = eigenvalues(free);
  for (Complex& zero : zeros) zero *= time;
  return zeros;
}

}  // namespace stepwire::linear
