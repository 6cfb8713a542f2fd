#include "engine/analyse/linear/delayed_step.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

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

}  // namespace

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

}  // namespace stepwire::linear
