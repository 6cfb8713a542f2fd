#include "engine/analyse/linear/sampled_chains.hpp"

#include <Eigen/LU>
#include <cmath>

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

}  // namespace stepwire::linear
