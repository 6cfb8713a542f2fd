#include "engine/analyse/linear/point_response.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace stepwire::linear {
namespace {

/// A state as a multiple of an earlier value of another one.
struct Link {
  Eigen::Index from = -1;  ///< -1 for a state that is kept
  double factor = 1.0;
};

std::vector<Link> links_of(const StateSpace& system) {
  std::vector<Link> links(static_cast<std::size_t>(system.A.rows()));
  for (Eigen::Index k = 0; k < system.A.rows(); ++k) {
    const auto row = system.A.row(k).array();
    Eigen::Index from = 0;
    const double most = row.abs().maxCoeff(&from);
    if (from == k || !(most > 0.0) || (row != 0.0).count() != 1 || !system.B.row(k).isZero(0.0)) continue;
    links[static_cast<std::size_t>(k)] = {from, row[from]};
  }
  return links;
}

/// Keeps one state of each ring of such states, which has no head.
void open_rings(std::vector<Link>& links) {
  for (std::size_t k = 0; k < links.size(); ++k) {
    std::size_t at = k;
    for (std::size_t steps = 0; links[at].from >= 0; ++steps) {
      if (steps == links.size()) links[at].from = -1;
      if (links[at].from >= 0) at = static_cast<std::size_t>(links[at].from);
    }
  }
}

/// Adds the steps and factors of the links from a state to its head, which is returned.
template <class Tail>
std::size_t follow(const std::vector<Link>& links, std::size_t at, Tail& tail) {
  for (; links[at].from >= 0; at = static_cast<std::size_t>(links[at].from)) {
    tail.into_states *= links[at].factor;
    tail.into_outputs *= links[at].factor;
    tail.steps += 1.0;
  }
  return at;
}

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

SampledChains::SampledChains(const StateSpace& system) : D_(system.D) {
  std::vector<Link> links = links_of(system);
  open_rings(links);
  std::vector<Eigen::Index> kept, place(links.size(), -1);
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (links[k].from >= 0) continue;
    place[k] = static_cast<Eigen::Index>(kept.size());
    kept.push_back(static_cast<Eigen::Index>(k));
  }
  count_ = links.size() - kept.size();
  A_ = system.A(kept, kept);
  B_ = system.B(kept, Eigen::all);
  C_ = system.C(Eigen::all, kept);
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    Tail tail{0, 0.0, system.A(kept, column), system.C.col(column)};
    if (links[k].from < 0 || (tail.into_states.isZero(0.0) && tail.into_outputs.isZero(0.0))) continue;
    tail.head = place[follow(links, k, tail)];
    tails_.push_back(std::move(tail));
  }
}

Eigen::MatrixXcd SampledChains::response(const Complex& z) const {
  Eigen::MatrixXcd M = -A_.cast<Complex>(), C = C_.cast<Complex>();
  M.diagonal().array() += z;
  for (const Tail& tail : tails_) {
    const Complex late = std::pow(z, -tail.steps);
    M.col(tail.head) -= late * tail.into_states;
    C.col(tail.head) += late * tail.into_outputs;
  }
  if (M.rows() == 0) return D_.cast<Complex>();
  return C * M.partialPivLu().solve(B_.cast<Complex>()) + D_;
}

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
  constexpr Eigen::Index few = 60;  // states, for the cost of n^3 a point
  if (system.sample_time == 0.0 && A.rows() <= few) near_rest_ = 1e-4 * A.norm();
  plain_.A = A;
  plain_.B = scale.cwiseInverse().asDiagonal() * system.B;
  plain_.C = system.C * scale.asDiagonal();
  const Eigen::HessenbergDecomposition<Eigen::MatrixXd> reduced(A);
  const Eigen::MatrixXd Q = reduced.matrixQ();
  hessenberg_ = reduced.matrixH();
  B_ = Q.transpose() * plain_.B;
  C_ = plain_.C * Q;
}

Eigen::MatrixXcd PointResponse::between(const Complex& point) const {
  if (chains_) return chains_->response(point);
  if (hessenberg_.rows() == 0) return D_.cast<Complex>();
  if (std::abs(point) < near_rest_) return near_rest(point);
  return C_.cast<Complex>() * solve(point, hessenberg_, B_.cast<Complex>()) + D_;
}

/// Returns the response by elimination in A itself. Its zeros keep several poles at rest apart from rounding,
/// which the reduction would turn into a singular matrix close to them.
Eigen::MatrixXcd PointResponse::near_rest(const Complex& point) const {
  Eigen::MatrixXcd M = -plain_.A.cast<Complex>();
  M.diagonal().array() += point;
  return plain_.C.cast<Complex>() * M.partialPivLu().solve(plain_.B.cast<Complex>()) + D_;
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
