#include "engine/analyse/linear/step_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

#include "engine/analyse/linear/delay_chain.hpp"
#include "engine/analyse/linear/delay_system.hpp"
#include "engine/analyse/linear/delayed_step.hpp"
#include "engine/analyse/linear/margins.hpp"

namespace stepwire::linear {

namespace {

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
