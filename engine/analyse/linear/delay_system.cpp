#include "engine/analyse/linear/delay_system.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analyse/linear/point_response.hpp"
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

std::vector<Complex> delay_poles(const StateSpace& system) {
  constexpr Eigen::Index nodes = 40;
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

namespace {

/// Follows the angle of the determinant along a line near the imaginary axis. Intervals are halved until the
/// angle between their ends is below 0.5 rad and unambiguous.
class Turns {
 public:
  Turns(const PointResponse& response, double beside) : response_(response), beside_(beside) {}

  /// Returns the change of the angle between two frequencies [rad]; std::nullopt if the determinant passes 0.
  std::optional<double> between(double low, double high) { return between(low, at(low), high, at(high), 0); }
  Complex at(double frequency) const { return response_.return_difference({beside_, frequency}); }

 private:
  std::optional<double> between(double low, const Complex& first, double high, const Complex& last,
                                int depth) {
    const Complex ratio = last / first;
    if (!std::isfinite(std::abs(ratio)) || ratio == 0.0) return std::nullopt;
    const double middle = 0.5 * (low + high);
    if (depth > 50 || !(middle > low && middle < high)) return std::nullopt;
    const Complex half = at(middle);
    const double whole = std::arg(ratio), parts = std::arg(half / first) + std::arg(last / half);
    if (std::abs(whole) < 0.5 && std::abs(parts - whole) < 1e-9 && std::abs(half / first - 1.0) < 0.7)
      return whole;
    const auto left = between(low, first, middle, half, depth + 1);
    const auto right = left ? between(middle, half, high, last, depth + 1) : left;
    if (!right) return std::nullopt;
    return *left + *right;
  }

  const PointResponse& response_;
  double beside_;
};

/// Returns the angle of det(1 - X); std::nullopt if the norm of X is not below 1, as then the angle is
/// ambiguous.
std::optional<double> angle_from_one(const Eigen::MatrixXcd& X) {
  if (!(X.operatorNorm() < 0.999)) return std::nullopt;
  double angle = 0.0;
  for (const Complex& value : X.eigenvalues()) angle += std::arg(1.0 - value);
  return angle;
}

}  // namespace

std::optional<int> count_unstable(const StateSpace& system) {
  const auto own = eigenvalues(system.A);
  double fastest = Characteristic(system).rate();
  for (const Complex& pole : own) fastest = std::max(fastest, std::abs(pole));
  const double beside = -1e-9 * fastest;
  const PointResponse response(system);
  Turns turns(response, beside);
  double turned = 0.0, low = 0.0;
  std::optional<double> rest;
  for (double high = 1e-3 * fastest; !rest; low = high, high *= 1.1) {
    if (high > 1e9 * fastest) return std::nullopt;
    const auto more = turns.between(low, high);
    if (!more) return std::nullopt;
    turned += *more;
    if (high > 10.0 * fastest) rest = angle_from_one(response.around({beside, high}));
  }
  const auto right = std::ranges::count_if(own, [&](const Complex& pole) { return pole.real() > beside; });
  const double count = static_cast<double>(right) - (turned - *rest) / std::numbers::pi;
  if (std::abs(count - std::round(count)) > 0.05) return std::nullopt;
  return static_cast<int>(std::lround(count));
}

}  // namespace stepwire::linear
