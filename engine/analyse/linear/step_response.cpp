#include "engine/analyse/linear/step_response.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

#include "engine/analyse/linear/delay_system.hpp"
#include "engine/analyse/linear/margins.hpp"

namespace stepwire::linear {
namespace {

/// A signal on a time grid, with its left and right limit at each point; 0 before the first one.
struct Past {
  std::vector<double> left, right;

  /// Returns the value `points` grid steps after the first point, as the right (`after`) or left limit.
  double at(double points, bool after) const {
    constexpr double rounding = 1e-6;
    const double nearest = std::round(points);
    if (std::abs(points - nearest) < rounding) {
      const auto i = static_cast<std::ptrdiff_t>(nearest);
      return i < 0 ? 0.0 : (after ? right : left)[static_cast<std::size_t>(i)];
    }
    if (points < 0.0) return 0.0;
    const auto i = static_cast<std::size_t>(points);
    const double part = points - std::floor(points);
    return (1.0 - part) * right[i] + part * left[i + 1];
  }
};

/// Integrates a system with delays and an input of 1, step by step. Within a step the delayed signals are
/// linear, so that one matrix exponential, computed once, gives the next state exactly. Past inputs of the
/// delays are stored with left and right limits, since a jump must not be interpolated.
class DelayedStep {
 public:
  DelayedStep(const StateSpace& system, double step)
      : system_(system), step_(step), past_(system.delays.size()) {
    const Eigen::Index n = system.A.rows(), all = system.B.cols(), d = all - 1;
    // State vector of the exponential: states, input, delayed signals, and their derivatives [1/step].
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + 1 + 2 * d, n + 1 + 2 * d);
    whole.topLeftCorner(n, n) = system.A * step;
    whole.block(0, n, n, all) = system.B * step;
    whole.block(n + 1, n + 1 + d, d, d).setIdentity();
    turn_ = whole.exp().topRows(n);
    x_ = Eigen::VectorXd::Zero(n);
    look(0, false);
    look(0, true);
  }

  double output() const { return y_; }
  void advance() {
    const Eigen::VectorXd from = delayed(point_, true), to = delayed(point_ + 1, false);
    Eigen::VectorXd all(turn_.cols());
    all << x_, Eigen::VectorXd::Ones(1), from, to - from;
    x_ = turn_ * all;
    ++point_;
    look(point_, false);
    look(point_, true);
  }

 private:
  Eigen::VectorXd delayed(std::size_t point, bool after) const {
    Eigen::VectorXd w(static_cast<Eigen::Index>(past_.size()));
    for (std::size_t k = 0; k < past_.size(); ++k)
      w[static_cast<Eigen::Index>(k)] =
          past_[k].at(static_cast<double>(point) - system_.delays[k].time / step_, after);
    return w;
  }

  /// Stores the inputs of the delays at a grid point, as left or right limit.
  void look(std::size_t point, bool after) {
    Eigen::VectorXd all(system_.B.cols());
    all << Eigen::VectorXd::Constant(1, point > 0 || after ? 1.0 : 0.0), delayed(point, after);
    const Eigen::VectorXd out = system_.C * x_ + system_.D * all;
    for (std::size_t k = 0; k < past_.size(); ++k)
      (after ? past_[k].right : past_[k].left).push_back(out[static_cast<Eigen::Index>(k) + 1]);
    y_ = out[0];
  }

  const StateSpace& system_;
  const double step_;
  Eigen::MatrixXd turn_;
  Eigen::VectorXd x_;
  std::vector<Past> past_;
  std::size_t point_ = 0;
  double y_ = 0.0;
};

/// Returns the step: at most 1/8 of the interval and 1/4 of the shortest delay, and a divisor of the first
/// delay.
double grid_step(const StateSpace& system, double interval) {
  double most = 0.125 * interval;
  for (const InnerDelay& delay : system.delays) most = std::min(most, 0.25 * delay.time);
  const double first = system.delays.front().time;
  return first / std::ceil(first / most * (1.0 - 1e-12));
}

/// Computes the unit step response of a continuous system with delays and one input, at `rows` multiples of
/// `interval` [s] from 0 on. The step size divides the first delay, so that jumps that return through that
/// delay are exactly on the grid. A step is exact if the delayed signals are linear within it.
std::vector<double> delayed_step(const StateSpace& system, double interval, std::size_t rows) {
  const double step = grid_step(system, interval);
  DelayedStep run(system, step);
  std::vector<double> y;
  double before = 0.0, here = run.output();
  for (double point = 0.0; y.size() < rows;) {
    const double wanted = static_cast<double>(y.size()) * interval / step;
    if (wanted <= point + 1e-9) {
      const double part = std::clamp(wanted - (point - 1.0), 0.0, 1.0);
      y.push_back(point == 0.0 ? here : before + part * (here - before));
      continue;
    }
    before = here;
    run.advance();
    here = run.output();
    point += 1.0;
  }
  return y;
}

constexpr int most_steps = 2000, steps = 800;

/// Returns the duration of the response [s].
double duration_of(const StateSpace& system) {
  double slowest = 0.0, fastest = 0.0;
  for (const Mode& mode : modes_of(system)) {
    const double decay = mode.damping * mode.frequency;
    if (std::isfinite(mode.frequency)) fastest = std::max(fastest, mode.frequency);
    if (decay > 1e-9 * mode.frequency && std::isfinite(decay)) slowest = std::max(slowest, 1.0 / decay);
  }
  if (slowest > 0.0) return 8.0 * slowest;
  return fastest > 0.0 ? 40.0 / fastest : 1.0;
}

/// Returns the transition matrix [A B; 0 I] of one step with the input held.
Eigen::MatrixXd held(const StateSpace& system, double step) {
  const Eigen::Index n = system.A.rows();
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + 1, n + 1);
  whole.topLeftCorner(n, n) = system.A;
  whole.topRightCorner(n, 1) = system.B;
  if (!system.is_sampled()) return (whole * step).exp();
  whole(n, n) = 1.0;
  return whole;
}

/// Sorts poles by their nearest predecessors, so that they continue the same branches.
void sort_like(const std::vector<Complex>& before, std::vector<Complex>& poles) {
  for (std::size_t i = 0; i < before.size() && i < poles.size(); ++i) {
    const auto nearest = std::min_element(poles.begin() + static_cast<std::ptrdiff_t>(i), poles.end(),
                                          [&](const Complex& a, const Complex& b) {
                                            return std::abs(a - before[i]) < std::abs(b - before[i]);
                                          });
    std::swap(poles[i], *nearest);
  }
}

/// Returns the factors of the gain: 0, then a thousandth to a thousand, with 1.
std::vector<double> locus_gains() {
  std::vector<double> gains{0.0};
  for (int k = -150; k <= 150; ++k) gains.push_back(std::pow(10.0, k / 50.0));
  return gains;
}

ResponseCurve delayed_response(const StateSpace& system, double step) {
  ResponseCurve curve{{}, delayed_step(system, step, steps + 1)};
  for (int k = 0; k <= steps; ++k) curve.x.push_back(k * step);
  return curve;
}

ResponseCurve held_response(const StateSpace& system, double step, int count) {
  const Eigen::MatrixXd turn = held(system, step);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(turn.rows());
  x[turn.rows() - 1] = 1.0;
  ResponseCurve curve;
  for (int k = 0; k <= count; ++k, x = (turn * x).eval()) {
    curve.x.push_back(k * step);
    curve.y.push_back((system.C * x.head(system.A.rows()))(0) + system.D(0, 0));
  }
  return curve;
}

/// Returns the response of a chain of delays: that of its rational part, later by the sum of the delays.
ResponseCurve later_response(const DelayChain& chain, double step) {
  const StateSpace& system = chain.rational;
  const double first = std::ceil(chain.time / step * (1.0 - 1e-12));
  const Eigen::MatrixXd turn = held(system, step);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(turn.rows());
  x[turn.rows() - 1] = 1.0;
  x = (held(system, std::max(0.0, first * step - chain.time)) * x).eval();
  ResponseCurve curve;
  for (int k = 0; k <= steps; ++k) {
    curve.x.push_back(k * step);
    curve.y.push_back(k < first ? 0.0 : (system.C * x.head(system.A.rows()))(0) + system.D(0, 0));
    if (k >= first) x = (turn * x).eval();
  }
  return curve;
}

/// Other delays far below the step of the curve are replaced by lines: exact steps, a fraction of such a
/// delay each, would be without end.
ResponseCurve response_with_delays(const StateSpace& system, double step) {
  constexpr double least_share = 0.02;
  constexpr Eigen::Index nodes = 4;
  if (const auto chain = delay_chain(system)) return later_response(*chain, step);
  const bool has_short = std::ranges::any_of(
      system.delays, [&](const InnerDelay& delay) { return delay.time < least_share * step; });
  if (!has_short) return delayed_response(system, step);
  const StateSpace longer = with_lines_below(system, least_share * step, nodes);
  return longer.delays.empty() ? held_response(longer, step, steps) : delayed_response(longer, step);
}

/// Returns the poles of a loop, the same number for each gain. Poles of delays beyond the resolution of the
/// lines are nan.
std::vector<Complex> locus_poles(const StateSpace& loop) {
  if (loop.delays.empty()) return eigenvalues(loop.A);
  constexpr Eigen::Index nodes = 20;
  double longest = 0.0;
  for (const InnerDelay& delay : loop.delays) longest = std::max(longest, delay.time);
  std::vector<Complex> poles = eigenvalues(with_lines(loop, nodes).A);
  for (Complex& pole : poles)
    if (std::abs(pole) * longest > 0.4 * nodes) pole = std::numeric_limits<double>::quiet_NaN();
  return poles;
}

}  // namespace

ResponseCurve step_response(const StateSpace& system) {
  const double step = system.is_sampled() ? system.sample_time : duration_of(system) / steps;
  if (!system.delays.empty()) return response_with_delays(system, step);
  const int count =
      system.is_sampled()
          ? static_cast<int>(std::clamp(std::ceil(duration_of(system) / step), 10.0, double{most_steps}))
          : steps;
  return held_response(system, step, count);
}

RootLocus root_locus(const StateSpace& system, double feedback) {
  RootLocus locus;
  const std::vector<double> gains = locus_gains();
  std::vector<std::vector<Complex>> rows;
  for (const double gain : gains) {
    std::vector<Complex> poles = locus_poles(system.closed(feedback * gain));
    if (!rows.empty()) sort_like(rows.back(), poles);
    rows.push_back(std::move(poles));
  }
  for (std::size_t branch = 0; branch < rows[0].size(); ++branch)
    for (std::size_t k = 0; k < gains.size(); ++k) {
      locus.gain.push_back(gains[k]);
      locus.real.push_back(rows[k][branch].real());
      locus.imaginary.push_back(rows[k][branch].imag());
      locus.branch.push_back(static_cast<double>(branch));
    }
  return locus;
}

}  // namespace stepwire::linear
