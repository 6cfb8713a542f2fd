#include "engine/analyse/linear/delay_system.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analyse/linear/delay_chain.hpp"
#include "engine/analyse/linear/poles.hpp"

namespace stepwire::linear {

namespace {

/// Returns the differentiation matrix at the Chebyshev points of a line from 0 to -time (L. N. Trefethen,
/// Spectral Methods in MATLAB, program cheb).
Eigen::MatrixXd differences(Eigen::Index nodes, double time) {
  const Eigen::Index n = nodes;
  Eigen::VectorXd x(n + 1), c(n + 1);
  for (Eigen::Index i = 0; i <= n; ++i) {
    x[i] = std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
    c[i] = (i == 0 || i == n ? 2.0 : 1.0) * (i % 2 == 0 ? 1.0 : -1.0);
  }
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(n + 1, n + 1);
  for (Eigen::Index i = 0; i <= n; ++i)
    for (Eigen::Index j = 0; j <= n; ++j)
      if (i != j) D(i, j) = c[i] / c[j] / (x[i] - x[j]);
  D.diagonal() = -D.rowwise().sum();
  return D * (2.0 / time);
}

/// Characteristic equation det T(s) = 0 of a system with delays.
class Characteristic {
 public:
  explicit Characteristic(const StateSpace& system)
      : system_(system), n_(system.A.rows()), d_(static_cast<Eigen::Index>(system.delays.size())) {
    constant_.resize(n_ + d_, n_ + d_);
    constant_.topLeftCorner(n_, n_) = -system.A;
    constant_.topRightCorner(n_, d_) = -system.B.rightCols(d_);
    constant_.bottomLeftCorner(d_, n_) = -system.C.bottomRows(d_);
    constant_.bottomRightCorner(d_, d_) = -system.D.bottomRightCorner(d_, d_);
  }

  /// Returns the root that Newton's method reaches from `s`; std::nullopt if it does not converge.
  std::optional<Complex> root_from(Complex s) const {
    for (int k = 0; k < 50; ++k) {
      const Complex step = newton_step(s);
      if (step == 0.0) return s;
      if (!std::isfinite(std::abs(step))) return std::nullopt;
      s += step;
      if (std::abs(step) <= 1e-13 * (std::abs(s) + rate())) return s;
    }
    return std::nullopt;
  }

  double rate() const {  ///< Rate of the shortest delay [1/s].
    double shortest = std::numeric_limits<double>::infinity();
    for (const InnerDelay& delay : system_.delays) shortest = std::min(shortest, delay.time);
    return 1.0 / shortest;
  }

 private:
  /// Returns -det T / (det T)' = -1 / trace(T^-1 T'); 0 at a root.
  Complex newton_step(const Complex& s) const {
    Eigen::MatrixXcd T = constant_.cast<Complex>();
    Eigen::VectorXcd slopes(n_ + d_);
    for (Eigen::Index i = 0; i < n_ + d_; ++i) {
      const double time = i < n_ ? 0.0 : system_.delays[static_cast<std::size_t>(i - n_)].time;
      const Complex turned = i < n_ ? s : std::exp(s * time);
      T(i, i) += turned;
      slopes[i] = i < n_ ? 1.0 : time * turned;
    }
    const Eigen::PartialPivLU<Eigen::MatrixXcd> parts(T);
    if (parts.determinant() == 0.0) return 0.0;
    const Eigen::MatrixXcd inverse = parts.inverse();
    return -1.0 / (inverse.diagonal().array() * slopes.array()).sum();
  }

  const StateSpace& system_;
  Eigen::Index n_, d_;
  Eigen::MatrixXd constant_;
};

/// System whose delays are lines of states that follow its own states.
class Lines {
 public:
  Lines(const StateSpace& system, Eigen::Index nodes)
      : system_(system), n_(system.A.rows()), d_(std::ssize(system.delays)), nodes_(nodes) {
    ends_ = Eigen::MatrixXd::Zero(d_, n_ + d_ * nodes);
    for (Eigen::Index k = 0; k < d_; ++k) ends_(k, n_ + (k + 1) * nodes - 1) = 1.0;
    starts_ = system.D.bottomRightCorner(d_, d_) * ends_;
    starts_.leftCols(n_) += system.C.bottomRows(d_);
  }

  StateSpace made() const {
    const Eigen::Index m = std::ssize(system_.inputs), p = std::ssize(system_.outputs), all = ends_.cols();
    StateSpace made = system_;
    made.delays.clear();
    made.states.resize(static_cast<std::size_t>(all));
    made.A = Eigen::MatrixXd::Zero(all, all);
    made.A.topRows(n_) = system_.B.rightCols(d_) * ends_;
    made.A.topLeftCorner(n_, n_) += system_.A;
    made.B = Eigen::MatrixXd::Zero(all, m);
    made.B.topRows(n_) = system_.B.leftCols(m);
    for (Eigen::Index k = 0; k < d_; ++k) put_line(k, made);
    made.C = system_.D.topRightCorner(p, d_) * ends_;
    made.C.leftCols(n_) += system_.C.topRows(p);
    made.D = system_.D.topLeftCorner(p, m);
    return made;
  }

 private:
  void put_line(Eigen::Index k, StateSpace& made) const {
    const Eigen::MatrixXd slopes = differences(nodes_, system_.delays[static_cast<std::size_t>(k)].time);
    const Eigen::Index first = n_ + k * nodes_, p = std::ssize(system_.outputs);
    made.A.middleRows(first, nodes_) = slopes.col(0).tail(nodes_) * starts_.row(k);
    made.A.block(first, first, nodes_, nodes_) += slopes.bottomRightCorner(nodes_, nodes_);
    made.B.middleRows(first, nodes_) = slopes.col(0).tail(nodes_) * system_.D.row(p + k).head(made.B.cols());
  }

  const StateSpace& system_;
  Eigen::Index n_, d_, nodes_;
  Eigen::MatrixXd ends_, starts_;  ///< Output and input of each line, as combinations of all states.
};

}  // namespace

StateSpace with_lines(const StateSpace& system, Eigen::Index nodes) {
  return Lines(system, nodes).made();
}

StateSpace with_lines_below(const StateSpace& system, double longest, Eigen::Index nodes) {
  std::vector<Eigen::Index> columns, rows;
  for (std::size_t i = 0; i < system.inputs.size(); ++i) columns.push_back(static_cast<Eigen::Index>(i));
  for (std::size_t o = 0; o < system.outputs.size(); ++o) rows.push_back(static_cast<Eigen::Index>(o));
  StateSpace parted = system;  // whose longer delays are inputs and outputs
  parted.delays.clear();
  std::vector<InnerDelay> longer;
  for (const bool is_short : {false, true})
    for (std::size_t k = 0; k < system.delays.size(); ++k) {
      const InnerDelay& delay = system.delays[k];
      if ((delay.time < longest) != is_short) continue;
      columns.push_back(std::ssize(system.inputs) + static_cast<Eigen::Index>(k));
      rows.push_back(std::ssize(system.outputs) + static_cast<Eigen::Index>(k));
      (is_short ? parted.delays : longer).push_back(delay);
      if (is_short) continue;
      parted.inputs.push_back(delay.in);
      parted.outputs.push_back(delay.out);
    }
  parted.B = system.B(Eigen::all, columns);
  parted.C = system.C(rows, Eigen::all);
  parted.D = system.D(rows, columns);
  StateSpace made = parted.delays.empty() ? parted : with_lines(parted, nodes);
  made.inputs = system.inputs;
  made.outputs = system.outputs;
  made.delays = longer;
  return made;
}

std::vector<Complex> delay_poles(const StateSpace& system) {
  constexpr Eigen::Index nodes = 40;
  if (with_loops_only(system).delays.empty()) return eigenvalues(system.A);
  const Characteristic equation(system);
  std::vector<Complex> found;
  for (const Complex& start : eigenvalues(with_lines(system, nodes).A)) {
    if (std::abs(start) > 0.5 * nodes * equation.rate()) continue;
    const auto root = equation.root_from(start);
    const auto is_near = [&](const Complex& other) {
      return std::abs(other - *root) < 1e-6 * (std::abs(other) + 1e-3 * equation.rate());
    };
    if (!root || std::abs(*root - start) > 0.05 * (std::abs(start) + equation.rate())) continue;
    if (std::ranges::none_of(found, is_near)) found.push_back(*root);
  }
  sort_by_size(found);
  return found;
}

}  // namespace stepwire::linear
