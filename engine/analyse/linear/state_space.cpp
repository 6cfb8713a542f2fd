#include "engine/analyse/linear/state_space.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <utility>

namespace stepwire::linear {
namespace {

/// Returns the indices of one own channel and of all delays, which begin at `first`.
std::vector<Eigen::Index> places(std::size_t own, std::size_t first, std::size_t delays) {
  std::vector<Eigen::Index> all{static_cast<Eigen::Index>(own)};
  for (std::size_t i = 0; i < delays; ++i) all.push_back(static_cast<Eigen::Index>(first + i));
  return all;
}

/// Returns the power of two nearest to the root of row / column.
double factor_of(double row, double column) {
  return std::exp2(std::round(0.5 * std::log2(row / column)));
}

/// Scales one state. Returns false, without scaling, if the norms would fall by less than 5 %.
bool scale_one(Eigen::MatrixXd& A, Eigen::Index i, Eigen::VectorXd& scale) {
  const double own = std::abs(A(i, i));
  const double row = A.row(i).cwiseAbs().sum() - own, column = A.col(i).cwiseAbs().sum() - own;
  if (!(row > 0.0 && column > 0.0)) return false;
  const double factor = factor_of(row, column);
  if (!(column * factor + row / factor < 0.95 * (column + row))) return false;
  scale[i] *= factor;
  A.row(i) /= factor;
  A.col(i) *= factor;
  return true;
}

constexpr double tolerance = 1e-10;  // for numbers with a largest of 1

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd>;

/// Returns the dimension of the controllable subspace: the range of B, then step by step the states that it
/// drives.
///
/// Each step turns A by as many reflections as B has columns, so that n steps cost n^3.
Eigen::Index staircase(Eigen::MatrixXd A, Eigen::MatrixXd B) {
  Eigen::Index reached = 0;
  while (A.rows() > 0 && B.cols() > 0) {
    const Svd svd(B, Eigen::ComputeThinV);
    const Eigen::Index rank = (svd.singularValues().array() > tolerance).count();
    reached += rank;
    if (rank == 0 || rank == A.rows()) break;
    const Eigen::HouseholderQR<Eigen::MatrixXd> range(B * svd.matrixV().leftCols(rank));
    A.applyOnTheLeft(range.householderQ().adjoint());
    A.applyOnTheRight(range.householderQ());
    const Eigen::Index rest = A.rows() - rank;
    B = A.bottomLeftCorner(rest, rank);
    A = A.bottomRightCorner(rest, rest).eval();
  }
  return reached;
}

std::vector<double> singular_values(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd all(A.rows(), A.rows() * B.cols()), next = B;
  for (Eigen::Index k = 0; k < A.rows(); ++k, next = (A * next).eval())
    all.middleCols(k * B.cols(), B.cols()) = next;
  constexpr Eigen::Index many = 100;  // for which rotations of pairs of columns take seconds
  const Eigen::VectorXd values =
      A.rows() > many ? Eigen::BDCSVD<Eigen::MatrixXd>(all).singularValues() : Svd(all).singularValues();
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

/// Marks the states that depend on marked ones, by the non-zero elements of A.
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

/// Returns the nodes (states and delays) that inputs reach and that reach outputs.
std::vector<char> nodes_between(const StateSpace& system) {
  const auto n = system.A.rows(), d = static_cast<Eigen::Index>(system.delays.size()),
             own_in = static_cast<Eigen::Index>(system.inputs.size()),
             own_out = static_cast<Eigen::Index>(system.outputs.size());
  Eigen::MatrixXd inner(n + d, n + d), into(n + d, own_in), out_of(own_out, n + d);
  inner.topLeftCorner(n, n) = system.A;
  inner.topRightCorner(n, d) = system.B.rightCols(d);
  inner.bottomLeftCorner(d, n) = system.C.bottomRows(d);
  inner.bottomRightCorner(d, d) = system.D.bottomRightCorner(d, d);
  into.topRows(n) = system.B.leftCols(own_in);
  into.bottomRows(d) = system.D.bottomLeftCorner(d, own_in);
  out_of.leftCols(n) = system.C.topRows(own_out);
  out_of.rightCols(d) = system.D.topRightCorner(own_out, d);
  auto nodes = spread(inner, rows_in_use(into));
  const auto shown = spread(inner.transpose(), rows_in_use(out_of.transpose()));
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = nodes[i] && shown[i];
  return nodes;
}

std::vector<Eigen::Index> first_places(std::size_t count) {
  std::vector<Eigen::Index> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(static_cast<Eigen::Index>(i));
  return all;
}

}  // namespace

std::vector<Channel> StateSpace::all_inputs() const {
  std::vector<Channel> all = inputs;
  for (const InnerDelay& delay : delays) all.push_back(delay.in);
  return all;
}

std::vector<Channel> StateSpace::all_outputs() const {
  std::vector<Channel> all = outputs;
  for (const InnerDelay& delay : delays) all.push_back(delay.out);
  return all;
}

StateSpace StateSpace::channel(std::size_t input, std::size_t output) const {
  const auto columns = places(input, inputs.size(), delays.size());
  const auto rows = places(output, outputs.size(), delays.size());
  return {A,      B(Eigen::all, columns), C(rows, Eigen::all), D(rows, columns),
          states, {inputs[input]},        {outputs[output]},   sample_time,
          delays};
}

StateSpace StateSpace::connected() const {
  const auto nodes = nodes_between(*this);
  StateSpace part = *this;
  part.states.clear();
  part.delays.clear();
  std::vector<Eigen::Index> kept, rows = first_places(outputs.size()), columns = first_places(inputs.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!nodes[i]) continue;
    kept.push_back(static_cast<Eigen::Index>(i));
    part.states.push_back(states[i]);
  }
  for (std::size_t i = 0; i < delays.size(); ++i) {
    if (!nodes[states.size() + i]) continue;
    rows.push_back(static_cast<Eigen::Index>(outputs.size() + i));
    columns.push_back(static_cast<Eigen::Index>(inputs.size() + i));
    part.delays.push_back(delays[i]);
  }
  part.A = A(kept, kept);
  part.B = B(kept, columns);
  part.C = C(rows, kept);
  part.D = D(rows, columns);
  return part;
}

StateSpace StateSpace::closed(double feedback) const {
  StateSpace loop = *this;
  const double share = 1.0 / (1.0 - feedback * D(0, 0));
  const Eigen::RowVectorXd C_own = C.row(0), D_own = D.row(0);
  const Eigen::VectorXd B_own = B.col(0) * (feedback * share), D_in = D.col(0) * (feedback * share);
  loop.A += B_own * C_own;
  loop.B += B_own * D_own;
  loop.C += D_in * C_own;
  loop.D += D_in * D_own;
  return loop;
}

Eigen::VectorXd balancing(Eigen::MatrixXd A) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(A.rows());
  bool again = true;
  for (int sweep = 0; again && sweep < 100; ++sweep) {
    again = false;
    for (Eigen::Index i = 0; i < A.rows(); ++i) again = scale_one(A, i, scale) || again;
  }
  return scale;
}

Rank controllability(const StateSpace& system) {
  return rank_of(system.A, system.B);
}

Rank observability(const StateSpace& system) {
  return rank_of(system.A.transpose(), system.C.transpose());
}

}  // namespace stepwire::linear
