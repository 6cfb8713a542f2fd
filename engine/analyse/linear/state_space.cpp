#include "engine/analyse/linear/state_space.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <Eigen/SparseCore>
#include <cmath>
#include <limits>
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

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd>;

constexpr double entry_error = 1e-13;  // of linearized entries, for numbers with a largest of 1
constexpr double clear = 30.0;         // times the error, above which a singular value counts
constexpr double lost = 1e-6;          // error at which no rank is certain

/// Returns the power of two nearest to a size; 1 for 0.
double near_power_of_two(double size) {
  return size > 0.0 && std::isfinite(size) ? std::exp2(std::round(std::log2(size))) : 1.0;
}

/// Scales A to a largest number of 1, and each column of B to one near 1.
void scale_time_and_channels(Eigen::MatrixXd& A, Eigen::MatrixXd& B) {
  if (const double size = A.cwiseAbs().maxCoeff(); size > 0.0) A /= size;
  for (Eigen::Index i = 0; i < B.cols(); ++i) B.col(i) /= near_power_of_two(B.col(i).cwiseAbs().maxCoeff());
}

/// Returns the largest numbers of the rows of |B|, |A| |B|, |A|^2 |B| and so on; 0 for a state that no input
/// reaches.
Eigen::VectorXd reach_of(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const Eigen::SparseMatrix<double> steps = A.cwiseAbs().sparseView();
  Eigen::MatrixXd next = B.cwiseAbs();
  Eigen::VectorXd reach = next.rowwise().sum();
  for (Eigen::Index k = 1; k < A.rows(); ++k) {
    next = (steps * next).eval();
    const Eigen::VectorXd wider = reach.cwiseMax(next.rowwise().sum());
    if (wider == reach) break;
    reach = wider;
  }
  return reach;
}

/// Takes away the states that no input reaches, and scales the others by powers of two to the same reach.
///
/// A change of units multiplies the rows of |A|^k |B| as it multiplies the states. So the scaled system, and
/// with it the rank, is the same in all units. Norms of rows and columns of A alone, as in balancing(), do
/// not see the sizes of B, and states without a way back keep their units.
void scale_by_reach(Eigen::MatrixXd& A, Eigen::MatrixXd& B) {
  constexpr int most_sweeps = 10;
  for (int sweep = 0; sweep < most_sweeps && A.rows() > 0; ++sweep) {
    scale_time_and_channels(A, B);
    const Eigen::VectorXd reach = reach_of(A, B);
    std::vector<Eigen::Index> reached;
    for (Eigen::Index i = 0; i < reach.size(); ++i)
      if (reach[i] > 0.0) reached.push_back(i);
    const Eigen::VectorXd scale = reach(reached).unaryExpr(&near_power_of_two);
    A = (scale.cwiseInverse().asDiagonal() * A(reached, reached) * scale.asDiagonal()).eval();
    B = (scale.cwiseInverse().asDiagonal() * B(reached, Eigen::all)).eval();
    if ((scale.array() == 1.0).all()) return;
  }
}

/// Computes the dimension of the controllable subspace: the range of B, then step by step the states that it
/// drives. A step divides the error of the numbers by the least singular value that counts.
///
/// Each step turns A by as many reflections as B has columns, so that n steps cost n^3.
void staircase(Eigen::MatrixXd A, Eigen::MatrixXd B, Rank& found) {
  double error =
      std::max(entry_error, static_cast<double>(A.rows()) * std::numeric_limits<double>::epsilon());
  while (A.rows() > 0 && B.cols() > 0) {
    const Svd svd(B, Eigen::ComputeThinV);
    const Eigen::ArrayXd values = svd.singularValues().array();
    const Eigen::Index rank = (values > clear * error).count();
    const bool is_near = ((values > error) && (values < 10.0 * clear * error)).any();
    found.certain = found.certain && !is_near && error < lost;
    found.rank += rank;
    if (rank == 0 || rank == A.rows()) break;
    error = std::max(error, error / values[rank - 1]);
    const Eigen::HouseholderQR<Eigen::MatrixXd> range(B * svd.matrixV().leftCols(rank));
    A.applyOnTheLeft(range.householderQ().adjoint());
    A.applyOnTheRight(range.householderQ());
    const Eigen::Index rest = A.rows() - rank;
    B = A.bottomLeftCorner(rest, rank);
    A = A.bottomRightCorner(rest, rest).eval();
  }
}

/// Returns the singular values of [B, A B, ...]; those of `states` - n further states are 0.
std::vector<double> singular_values(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, Eigen::Index states) {
  std::vector<double> values;
  if (A.size() > 0) {
    Eigen::MatrixXd all(A.rows(), A.rows() * B.cols()), next = B;
    for (Eigen::Index k = 0; k < A.rows(); ++k, next = (A * next).eval())
      all.middleCols(k * B.cols(), B.cols()) = next;
    constexpr Eigen::Index many = 100;  // for which rotations of pairs of columns take seconds
    const Eigen::VectorXd found =
        A.rows() > many ? Eigen::BDCSVD<Eigen::MatrixXd>(all).singularValues() : Svd(all).singularValues();
    values.assign(found.begin(), found.end());
  }
  values.resize(static_cast<std::size_t>(states), 0.0);
  return values;
}

Rank rank_of(Eigen::MatrixXd A, Eigen::MatrixXd B) {
  if (A.size() == 0 || B.size() == 0) return {};
  const Eigen::Index states = A.rows();
  const Eigen::VectorXd scale = balancing(A);
  A = (scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal()).eval();
  B = (scale.cwiseInverse().asDiagonal() * B).eval();
  scale_by_reach(A, B);
  Rank found;
  staircase(A, B, found);
  found.singular_values = singular_values(A, B, states);
  return found;
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
