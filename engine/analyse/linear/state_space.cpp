#include "engine/analyse/linear/state_space.hpp"

#include <utility>

namespace stepwire::linear {

StateSpace StateSpace::channel(std::size_t input, std::size_t output) const {
  const auto i = static_cast<Eigen::Index>(input), o = static_cast<Eigen::Index>(output);
  return {A,      B.col(i),        C.row(o),          D.block(o, i, 1, 1),
          states, {inputs[input]}, {outputs[output]}, sample_time};
}

namespace {

/// Which states follow from those that are marked, by the numbers of A that are not 0.
std::vector<char> spread(const Eigen::MatrixXd& A, std::vector<char> marked) {
  std::vector<Eigen::Index> queue;
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    if (marked[static_cast<std::size_t>(i)]) queue.push_back(i);
  while (!queue.empty()) {
    const Eigen::Index from = queue.back();
    queue.pop_back();
    for (Eigen::Index to = 0; to < A.rows(); ++to)
      if (A(to, from) != 0.0 && !std::exchange(marked[static_cast<std::size_t>(to)], 1)) queue.push_back(to);
  }
  return marked;
}

std::vector<char> rows_in_use(const Eigen::MatrixXd& matrix) {
  std::vector<char> used;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) used.push_back((matrix.row(i).array() != 0.0).any());
  return used;
}

}  // namespace

StateSpace StateSpace::connected() const {
  const auto reached = spread(A, rows_in_use(B)), shown = spread(A.transpose(), rows_in_use(C.transpose()));
  std::vector<Eigen::Index> kept;
  StateSpace part = *this;
  part.states.clear();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!reached[i] || !shown[i]) continue;
    kept.push_back(static_cast<Eigen::Index>(i));
    part.states.push_back(states[i]);
  }
  part.A = A(kept, kept);
  part.B = B(kept, Eigen::all);
  part.C = C(Eigen::all, kept);
  return part;
}

StateSpace StateSpace::closed(double feedback) const {
  StateSpace loop = *this;
  const double share = 1.0 / (1.0 - feedback * D(0, 0));
  loop.A = A + B * (feedback * share) * C;
  loop.B = B * share;
  loop.C = C * share;
  loop.D = D * share;
  return loop;
}

}  // namespace stepwire::linear
