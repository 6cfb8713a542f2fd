#include "engine/analyse/linear/point_response.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <limits>

#include "engine/analyse/linear/balance.hpp"

namespace stepwire::linear {

namespace {

/// Solves (point - H) X = B for H in upper Hessenberg form by elimination with row exchanges.
Eigen::MatrixXcd solve(const Complex& point, const Eigen::MatrixXd& H, Eigen::MatrixXcd B) {
  const Eigen::Index n = H.rows();
  // Rows are contiguous, as the elimination goes along them.
  Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> M = -H.cast<Complex>();
  M.diagonal().array() += point;
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    if (std::abs(M(k + 1, k)) > std::abs(M(k, k))) {
      M.row(k).tail(n - k).swap(M.row(k + 1).tail(n - k));
      B.row(k).swap(B.row(k + 1));
    }
    if (M(k, k) == 0.0 || M(k + 1, k) == 0.0) continue;
    const Complex factor = M(k + 1, k) / M(k, k);
    M.row(k + 1).tail(n - k) -= factor * M.row(k).tail(n - k);
    B.row(k + 1) -= factor * B.row(k);
  }
  for (Eigen::Index i = 0; i < B.cols(); ++i) {
    Eigen::VectorXcd column = B.col(i);
    M.triangularView<Eigen::Upper>().solveInPlace(column);
    B.col(i) = column;
  }
  return B;
}

/// Returns the largest gain from the first input to the first output for any phases of the delays, which join
/// the others: |G00| + |G0d| (1 - |Gdd|)^-1 |Gd0|. Infinite if the inverse, a sum over all ways around, does
/// not converge.
double bound_of(const Eigen::MatrixXcd& G) {
  const Eigen::Index d = G.rows() - 1;
  const Eigen::MatrixXd sizes = G.cwiseAbs();
  if (d == 0) return sizes(0, 0);
  const Eigen::MatrixXd inverse = (Eigen::MatrixXd::Identity(d, d) - sizes.bottomRightCorner(d, d)).inverse();
  if (!inverse.allFinite() || (inverse.array() < 0.0).any()) return std::numeric_limits<double>::infinity();
  return sizes(0, 0) + sizes.row(0).tail(d) * inverse * sizes.col(0).tail(d);
}

}  // namespace

double largest_gain(const Eigen::MatrixXd& direct) {
  return bound_of(direct.cast<Complex>());
}

PointResponse::PointResponse(const StateSpace& system)
    : B_(system.B), C_(system.C), D_(system.D), delays_(system.delays) {
  if (system.A.rows() == 0) return;
  constexpr std::size_t fewest = 8;  // delayed states
  if (system.sample_time > 0.0 && chains_.emplace(system).count() >= fewest) return;
  chains_.reset();
  const Eigen::VectorXd scale = balancing(system.A);
  const Eigen::MatrixXd A = scale.cwiseInverse().asDiagonal() * system.A * scale.asDiagonal();
  const Eigen::HessenbergDecomposition<Eigen::MatrixXd> reduced(A);
  const Eigen::MatrixXd Q = reduced.matrixQ();
  hessenberg_ = reduced.matrixH();
  B_ = Q.transpose() * (scale.cwiseInverse().asDiagonal() * system.B);
  C_ = (system.C * scale.asDiagonal()) * Q;
}

Eigen::MatrixXcd PointResponse::between(const Complex& point) const {
  if (chains_) return chains_->response(point);
  if (hessenberg_.rows() == 0) return D_.cast<Complex>();
  return C_.cast<Complex>() * solve(point, hessenberg_, B_.cast<Complex>()) + D_;
}

/// Returns the factor exp(-s T) of each delay.
Eigen::VectorXcd PointResponse::turned(const Complex& point) const {
  Eigen::VectorXcd factors(static_cast<Eigen::Index>(delays_.size()));
  for (std::size_t i = 0; i < delays_.size(); ++i)
    factors[static_cast<Eigen::Index>(i)] = std::exp(-point * delays_[i].time);
  return factors;
}

Complex PointResponse::at(const Complex& point) const {
  const Eigen::MatrixXcd G = between(point);
  const auto d = static_cast<Eigen::Index>(delays_.size());
  if (d == 0) return G(0, 0);
  const Eigen::VectorXcd factors = turned(point);
  const Eigen::MatrixXcd loop =
      Eigen::MatrixXcd::Identity(d, d) - factors.asDiagonal() * G.bottomRightCorner(d, d);
  const Eigen::VectorXcd into = factors.asDiagonal() * G.col(0).tail(d);
  return G(0, 0) + (G.row(0).tail(d) * loop.partialPivLu().solve(into))(0);
}

double PointResponse::bound(const Complex& point) const {
  return bound_of(between(point));
}

Eigen::MatrixXcd PointResponse::around(const Complex& point) const {
  const auto d = static_cast<Eigen::Index>(delays_.size());
  return turned(point).asDiagonal() * between(point).bottomRightCorner(d, d);
}

Complex PointResponse::return_difference(const Complex& point) const {
  const Eigen::MatrixXcd X = around(point);
  return (Eigen::MatrixXcd::Identity(X.rows(), X.cols()) - X).determinant();
}

}  // namespace stepwire::linear
