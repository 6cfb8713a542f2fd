#include "engine/analyse/linear/poles.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/linear/delay_system.hpp"

namespace stepwire::linear {
namespace {

/// Returns the groups of states that depend on each other in both directions, directly or through others.
std::vector<std::vector<Eigen::Index>> groups_of(const Eigen::MatrixXd& A) {
  const Eigen::Index n = A.rows();
  Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> reaches = (A.array() != 0.0).matrix();
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index i = 0; i < n; ++i)
      if (reaches(i, k)) reaches.row(i) = reaches.row(i).array() || reaches.row(k).array();
  std::vector<char> done(static_cast<std::size_t>(n), 0);
  std::vector<std::vector<Eigen::Index>> groups;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (done[static_cast<std::size_t>(i)]) continue;
    groups.push_back({i});
    for (Eigen::Index j = i + 1; j < n; ++j)
      if (reaches(i, j) && reaches(j, i)) groups.back().push_back(j), done[static_cast<std::size_t>(j)] = 1;
  }
  return groups;
}

Eigen::MatrixXd balanced(const Eigen::MatrixXd& A) {
  const Eigen::VectorXd scale = balancing(A);
  return scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal();
}

constexpr double rank_tolerance = 1e-13;  // for matrices with rows and columns near 1

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

/// Returns the power of two nearest to a size; 1 for 0 and non-finite sizes.
double power_of_two(double size) {
  return size > 0.0 && std::isfinite(size) ? std::exp2(std::round(std::log2(size))) : 1.0;
}

double largest(const Eigen::MatrixXd& matrix) {
  return matrix.size() > 0 ? matrix.cwiseAbs().maxCoeff() : 0.0;
}

/// Returns a rate near those of the system: of its states, or of an integrator with a direct path.
double rate_of(const Matrices& m) {
  const double states = largest(m.A), beside = largest(m.D);
  if (states > 0.0) return power_of_two(states);
  return beside > 0.0 ? power_of_two(largest(m.C * m.B) / beside) : 1.0;
}

void scale_states(Matrices& m, const Eigen::VectorXd& by) {
  const Eigen::VectorXd back = by.cwiseInverse();
  m.A = back.asDiagonal() * m.A * by.asDiagonal();
  m.B = back.asDiagonal() * m.B;
  m.C = m.C * by.asDiagonal();
}

/// Scales inputs and outputs to a largest number near 1.
void scale_channels(Matrices& m) {
  for (Eigen::Index i = 0; i < m.B.cols(); ++i) {
    const double size = power_of_two(std::max(largest(m.B.col(i)), largest(m.D.col(i))));
    m.B.col(i) /= size;
    m.D.col(i) /= size;
  }
  for (Eigen::Index i = 0; i < m.C.rows(); ++i) {
    const double size = power_of_two(std::max(largest(m.C.row(i)), largest(m.D.row(i))));
    m.C.row(i) /= size;
    m.D.row(i) /= size;
  }
}

/// Returns powers of two that balance the states with the channels. For each state, the norms of its row with
/// inputs and of its column with outputs become similar.
Eigen::VectorXd balancing_with_channels(const Matrices& m) {
  const Eigen::Index n = m.A.rows();
  Eigen::VectorXd by = Eigen::VectorXd::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double own = std::abs(m.A(i, i));
    const double row = m.A.row(i).cwiseAbs().sum() - own + m.B.row(i).cwiseAbs().sum();
    const double column = m.A.col(i).cwiseAbs().sum() - own + m.C.col(i).cwiseAbs().sum();
    if (row > 0.0 && column > 0.0) by[i] = power_of_two(std::sqrt(row / column));
  }
  return by;
}

/// Scales states, time, inputs and outputs to numbers near 1; returns the scale of time.
double scale(Matrices& m) {
  scale_states(m, balancing(m.A));
  const double rate = rate_of(m);
  m.A /= rate;
  m.B /= rate;
  for (int sweep = 0; sweep < 20; ++sweep) {
    scale_channels(m);
    scale_states(m, balancing_with_channels(m));
  }
  scale_channels(m);
  return rate;
}

/// Orthogonal transform after which the rows beyond the rank are 0.
struct Turned {
  Eigen::MatrixXd turn;
  Eigen::Index rank = 0;
};

Turned turned_rows(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return {Eigen::MatrixXd::Identity(matrix.rows(), matrix.rows())};
  const Svd svd(matrix, Eigen::ComputeFullU);
  return {svd.matrixU().transpose(), rank_of(svd)};
}

/// Orthogonal basis of the states whose first members are those that rows determine. Its matrix is a product
/// of few reflections, so that a change of basis costs n^2.
class Determined {
 public:
  explicit Determined(const Eigen::MatrixXd& rows)
      : reflections_(rows.transpose()), few_(std::min(rows.rows(), rows.cols())) {
    const Eigen::MatrixXd R = reflections_.matrixQR().topRows(few_).triangularView<Eigen::Upper>();
    const Svd svd(R, Eigen::ComputeFullU);
    turn_ = svd.matrixU();
    count = rank_of(svd);
  }

  Eigen::Index count = 0;

  /// Returns the transpose of the basis times a matrix.
  Eigen::MatrixXd rows_of(Eigen::MatrixXd matrix) const {
    matrix.applyOnTheLeft(reflections_.householderQ().adjoint());
    matrix.topRows(few_) = (turn_.transpose() * matrix.topRows(few_)).eval();
    return matrix;
  }
  /// Returns a matrix times the basis.
  Eigen::MatrixXd columns_of(Eigen::MatrixXd matrix) const {
    matrix.applyOnTheRight(reflections_.householderQ());
    matrix.leftCols(few_) = (matrix.leftCols(few_) * turn_).eval();
    return matrix;
  }

 private:
  Eigen::HouseholderQR<Eigen::MatrixXd> reflections_;
  Eigen::Index few_;
  Eigen::MatrixXd turn_;
};

/// Reduces a system until D has full row rank. Each pass removes the outputs that do not depend directly on
/// an input, with the states that they determine (Emami-Naeini and Van Dooren).
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
    const Determined states(C.bottomRows(lower));
    const Eigen::Index fixed = states.count;
    if (fixed == 0) break;
    // The outputs determine the first of these states; the others remain free.
    const Eigen::MatrixXd A = states.columns_of(states.rows_of(m.A)), B = states.rows_of(m.B),
                          C1 = states.columns_of(m.C);
    m.C = stacked(C1.rightCols(n - fixed), A.topRightCorner(fixed, n - fixed));
    m.D = stacked(m.D, B.topRows(fixed));
    m.A = A.bottomRightCorner(n - fixed, n - fixed);
    m.B = B.bottomRows(n - fixed);
  }
  return m;
}

double largest_of(const std::vector<Complex>& poles) {
  double largest = 0.0;
  for (const Complex& pole : poles) largest = std::max(largest, std::abs(pole));
  return largest;
}

/// Returns the fastest growing mode of all states, beyond rounding; std::nullopt if no mode grows.
std::optional<Complex> growing(const StateSpace& system) {
  constexpr double rounding = 1e-8;
  std::optional<Complex> found;
  double fastest = 0.0;
  const std::vector<Complex> poles = poles_of(system);
  const double largest = largest_of(poles);
  for (const Complex& pole : poles) {
    const double growth = system.is_sampled() ? std::abs(pole) - 1.0 : pole.real();
    if (growth <= rounding * (system.is_sampled() ? 1.0 : largest) || growth <= fastest) continue;
    fastest = growth;
    found = pole;
  }
  return found;
}

}  // namespace

void sort_by_size(std::vector<Complex>& values) {
  std::ranges::sort(values, [](const Complex& a, const Complex& b) {
    const double size_a = std::abs(a), size_b = std::abs(b);
    if (std::abs(size_a - size_b) > 1e-12 * std::max(size_a, size_b)) return size_a < size_b;
    return a.real() != b.real() ? a.real() < b.real() : a.imag() > b.imag();
  });
}

std::vector<Complex> eigenvalues(const Eigen::MatrixXd& A) {
  std::vector<Complex> values;
  for (const auto& group : groups_of(A)) {
    if (group.size() == 1) {
      values.emplace_back(A(group[0], group[0]));
      continue;
    }
    const Eigen::MatrixXd block = A(group, group);
    const Eigen::VectorXcd found = balanced(block).eigenvalues();
    values.insert(values.end(), found.begin(), found.end());
  }
  sort_by_size(values);
  return values;
}

std::vector<Complex> poles_of(const StateSpace& system) {
  return system.delays.empty() ? eigenvalues(system.A) : delay_poles(system);
}

std::vector<Mode> modes_of(const StateSpace& system) {
  std::vector<Mode> modes;
  for (const Complex& pole : poles_of(system)) {
    const Complex s = system.is_sampled() ? std::log(pole) / system.sample_time : pole;
    const double frequency = std::abs(s);
    if (!std::isfinite(frequency))  // z = 0: decays within a sample
      modes.push_back({pole, std::numeric_limits<double>::infinity(), 1.0});
    else
      modes.push_back({pole, frequency, frequency > 0.0 ? -s.real() / frequency : 0.0});
  }
  return modes;
}

bool is_stable(const StateSpace& system) {
  if (!system.A.allFinite()) return false;
  if (!system.delays.empty()) return count_unstable(system) == 0;
  const std::vector<Complex> poles = eigenvalues(system.A);
  const double largest = largest_of(poles);
  return std::ranges::all_of(poles, [&](const Complex& pole) { return decays(system, pole, largest); });
}

bool decays(const StateSpace& system, const Complex& pole, double largest) {
  constexpr double rounding = 1e-12;
  if (!std::isfinite(std::abs(pole))) return false;
  return system.is_sampled() ? std::abs(pole) < 1.0 - rounding : pole.real() < -rounding * largest;
}

Stability stability_of(const StateSpace& system) {
  const StateSpace part = system.connected();
  Stability found;
  if (part.delays.empty() || !part.A.allFinite()) {
    found.stable = is_stable(part);
  } else {
    const auto unstable = count_unstable(part);
    found.stable = unstable == 0;
    found.known = unstable.has_value();
  }
  if (!found.stable || part.states.size() == system.states.size()) return found;
  found.hidden = growing(system);
  found.stable = !found.hidden;
  return found;
}

std::vector<Complex> zeros_of(const StateSpace& system) {
  if (!system.delays.empty()) return {};
  if (system.A.size() == 0 || system.B.size() == 0 || system.C.size() == 0) return {};
  Matrices m{system.A, system.B, system.C, system.D};
  const double rate = scale(m);
  m = with_full_rows(with_full_rows(std::move(m)).transposed()).transposed();
  if (m.A.rows() == 0) return {};
  Eigen::MatrixXd free = m.A;
  if (m.D.size() > 0) free -= m.B * m.D.colPivHouseholderQr().solve(m.C);
  std::vector<Complex> zeros = eigenvalues(free);
  for (Complex& zero : zeros) zero *= rate;
  return zeros;
}

}  // namespace stepwire::linear
