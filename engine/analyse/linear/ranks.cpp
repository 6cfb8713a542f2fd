#include "engine/analyse/linear/ranks.hpp"

#include <Eigen/SVD>
#include <algorithm>

#include "engine/analyse/linear/balance.hpp"

namespace stepwire::linear {

namespace {

constexpr double tolerance = 1e-10;  // for numbers with a largest of 1

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd>;

/// Returns the dimension of the controllable subspace: the range of B, then step by step the states that it
/// drives.
Eigen::Index staircase(Eigen::MatrixXd A, Eigen::MatrixXd B) {
  Eigen::Index reached = 0;
  while (A.rows() > 0 && B.cols() > 0) {
    const Svd svd(B, Eigen::ComputeFullU);
    const Eigen::Index rank = (svd.singularValues().array() > tolerance).count();
    reached += rank;
    if (rank == 0 || rank == A.rows()) break;
    const Eigen::MatrixXd turned = svd.matrixU().transpose() * A * svd.matrixU();
    const Eigen::Index rest = A.rows() - rank;
    B = turned.bottomLeftCorner(rest, rank);
    A = turned.bottomRightCorner(rest, rest).eval();
  }
  return reached;
}

std::vector<double> singular_values(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd all(A.rows(), A.rows() * B.cols()), next = B;
  for (Eigen::Index k = 0; k < A.rows(); ++k, next = (A * next).eval())
    all.middleCols(k * B.cols(), B.cols()) = next;
  const Eigen::VectorXd values = Svd(all).singularValues();
  return {values.begin(), values.end()};
}

Rank rank_of(const Eigen::MatrixXd& plain_A, const Eigen::MatrixXd& plain_B) {
  if (plain_A.size() == 0 || plain_B.size() == 0) return {};
  const Eigen::VectorXd scale = balancing(plain_A);
  Eigen::MatrixXd A = scale.cwiseInverse().asDiagonal() * plain_A * scale.asDiagonal();
  Eigen::MatrixXd B = scale.cwiseInverse().asDiagonal() * plain_B;
  if (const double size = A.cwiseAbs().maxCoeff(); size > 0.0) A /= size;
  for (Eigen::Index i = 0; i < B.cols(); ++i)
    if (const double size = B.col(i).cwiseAbs().maxCoeff(); size > 0.0) B.col(i) /= size;
  return {staircase(A, B), singular_values(A, B)};
}

}  // namespace

Rank controllability(const StateSpace& system) {
  return rank_of(system.A, system.B);
}

Rank observability(const StateSpace& system) {
  return rank_of(system.A.transpose(), system.C.transpose());
}

}  // namespace stepwire::linear
