#include "engine/analyse/linear/step_response.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "engine/analyse/linear/delay_system.hpp"
#include "engine/analyse/linear/gain_at_rest.hpp"
#include "engine/analyse/linear/margins.hpp"
#include "engine/base/control/design.hpp"

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
    turn_ = control::exponential(whole).topRows(n);
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

/// Times of the rows of a response. The spacing follows the modes that have not decayed: a hundredth of a
/// time constant and of a period, and an 800th of the whole. It grows by powers of two, so that a few
/// transition matrices are enough.
class RowTimes {
 public:
  explicit RowTimes(const StateSpace& system) {
    double slowest = 0.0, fastest = 0.0;
    for (const Mode& mode : modes_of(system)) {
      if (!std::isfinite(mode.frequency) || mode.frequency == 0.0) continue;
      const double decay = mode.damping * mode.frequency;
      const bool decays = decay > 1e-9 * mode.frequency;
      fastest = std::max(fastest, mode.frequency);
      if (decays) slowest = std::max(slowest, 1.0 / decay);
      comes_to_rest_ = comes_to_rest_ && decays;
      const double period = 2.0 * std::numbers::pi / mode.frequency;
      scales_.push_back({decays ? 2.0 * constants / decay : std::numeric_limits<double>::infinity(),
                         0.01 * (decays ? std::min(period, 1.0 / decay) : period)});
    }
    duration_ = slowest > 0.0 ? constants * slowest : fastest > 0.0 ? 40.0 / fastest : 1.0;
    if (system.is_sampled()) duration_ = std::max(duration_, least_samples * system.sample_time);
    unit_ = system.is_sampled() ? system.sample_time : spacing(0.0);
  }

  double duration() const { return duration_; }
  bool comes_to_rest() const { return comes_to_rest_; }  ///< All modes decay.
  double time_constant() const { return duration_ / constants; }
  double unit() const { return unit_; }  ///< The smallest spacing [s].
  /// Returns the largest spacing that shows what moves at a time [s].
  double spacing(double time) const {
    double least = duration_ / steps;
    for (const Scale& scale : scales_)
      if (time < scale.until) least = std::min(least, scale.spacing);
    return least;
  }

 private:
  struct Scale {
    double until, spacing;  ///< [s]
  };
  static constexpr double constants = 8.0;  ///< Duration of a mode in time constants.
  static constexpr double least_samples = 10.0;
  static constexpr int steps = 800;

  std::vector<Scale> scales_;
  double duration_ = 0.0, unit_ = 0.0;
  bool comes_to_rest_ = true;
};

/// Decides where a response ends: after its duration and where it has stayed at its last value for a time
/// constant. Modes whose parts are larger than the whole way take longer than 8 time constants.
///
/// A settling time by the last row has the error of that row over the band of 2 %, times a time constant.
class End {
 public:
  End(const StateSpace& system, const RowTimes& times) : times_(times) {
    if (times.comes_to_rest()) rest_ = gain_at_rest(system);
  }

  /// True at the last row.
  bool is_at(double time, double y) {
    constexpr double rest_of_way = 3e-5, most_durations = 4.0;
    if (time == 0.0) first_ = y;
    if (std::abs(y - rest_) > rest_of_way * std::abs(rest_ - first_)) outside_ = time;
    if (time < times_.duration() * (1.0 - 1e-9)) return false;
    return time - outside_ >= times_.time_constant() || std::isnan(rest_) || rest_ == first_ ||
           time > most_durations * times_.duration();
  }

 private:
  const RowTimes& times_;
  double rest_ = std::numeric_limits<double>::quiet_NaN();  ///< Last value, if there is one.
  double first_ = 0.0, outside_ = 0.0;
};

/// Returns the transition matrix [A B; 0 I] of one step with the input held.
Eigen::MatrixXd held(const StateSpace& system, double step) {
  const Eigen::Index n = system.A.rows();
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + 1, n + 1);
  whole.topLeftCorner(n, n) = system.A;
  whole.topRightCorner(n, 1) = system.B;
  if (!system.is_sampled()) return control::exponential(whole * step);
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

/// Adds the extreme between two rows at which the slope has opposite signs: that of the cubic through them.
void add_extreme(ResponseCurve& curve, double x, double y, double slope_before, double slope) {
  const double length = x - curve.x.back(), from = curve.y.back();
  if (!(slope_before * slope < 0.0)) return;
  const auto slope_at = [&](double part) {
    return 6.0 * part * (1.0 - part) * (y - from) / length +
           (3.0 * part - 1.0) * (part - 1.0) * slope_before + part * (3.0 * part - 2.0) * slope;
  };
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i)
    (slope_at(0.5 * (low + high)) * slope_before > 0.0 ? low : high) = 0.5 * (low + high);
  const double p = low, q = 1.0 - p;
  curve.x.push_back(curve.x.back() + p * length);
  curve.y.push_back(from * q * q * (1.0 + 2.0 * p) + y * p * p * (3.0 - 2.0 * p) +
                    length * p * q * (q * slope_before - p * slope));
}

/// Walks along the response of a system without delays.
class HeldStep {
 public:
  HeldStep(const StateSpace& system, const RowTimes& times)
      : system_(system), times_(times), end_(system, times) {
    x_ = Eigen::VectorXd::Zero(system.A.rows() + 1);
    x_[system.A.rows()] = 1.0;
  }

  ResponseCurve curve() {
    ResponseCurve curve;
    for (std::int64_t at = 0;; at += std::int64_t{1} << level_) {
      const double time = static_cast<double>(at) * times_.unit();
      add(curve, time);
      if (end_.is_at(time, curve.y.back())) return curve;
      choose_level(time);
      x_ = (turn() * x_).eval();
    }
  }

 private:
  static constexpr int most_of_level = 5000;  ///< Rows after which the spacing doubles in any case.

  void add(ResponseCurve& curve, double time) {
    const Eigen::Index n = system_.A.rows();
    const double y = (system_.C * x_.head(n))(0) + system_.D(0, 0);
    const double slope = system_.is_sampled() ? 0.0 : (system_.C * (system_.A * x_.head(n) + system_.B))(0);
    const bool is_dense = !curve.x.empty() && time - curve.x.back() <= 5.0 * times_.spacing(time);
    if (is_dense) add_extreme(curve, time, y, slope_, slope);
    slope_ = slope;
    curve.x.push_back(time);
    curve.y.push_back(y);
  }

  void choose_level(double time) {
    const double most = times_.spacing(time) * (1.0 + 1e-9);
    const int before = level_;
    while (std::ldexp(times_.unit(), level_ + 1) <= most) ++level_;
    if (level_ == before && ++rows_of_level_ > most_of_level) ++level_;
    if (level_ != before) rows_of_level_ = 0;
  }

  const Eigen::MatrixXd& turn() {
    while (std::ssize(turns_) <= level_)
      turns_.push_back(system_.is_sampled() && !turns_.empty()
                           ? (turns_.back() * turns_.back()).eval()
                           : held(system_, std::ldexp(times_.unit(), static_cast<int>(turns_.size()))));
    return turns_[static_cast<std::size_t>(level_)];
  }

  const StateSpace& system_;
  const RowTimes& times_;
  End end_;
  std::vector<Eigen::MatrixXd> turns_;
  Eigen::VectorXd x_;
  double slope_ = 0.0;
  int level_ = 0, rows_of_level_ = 0;
};

ResponseCurve held_response(const StateSpace& system) {
  const RowTimes times(system);
  return HeldStep(system, times).curve();
}

/// Returns the response of a chain of delays: that of its rational part, later by the sum of the delays.
ResponseCurve later_response(const DelayChain& chain) {
  const ResponseCurve rational = held_response(chain.rational);
  constexpr int rows_before = 100;
  ResponseCurve curve;
  for (int k = 0; k < rows_before && chain.time > 0.0; ++k) {
    curve.x.push_back(k * chain.time / rows_before);
    curve.y.push_back(0.0);
  }
  for (std::size_t i = 0; i < rational.x.size(); ++i) {
    curve.x.push_back(chain.time + rational.x[i]);
    curve.y.push_back(rational.y[i]);
  }
  return curve;
}

/// Returns the response at grid points of at least this spacing, and at each extreme.
ResponseCurve delayed_response(const StateSpace& system, const RowTimes& times) {
  constexpr double most_points = 2e4;
  const double step = grid_step(system, std::max(times.unit(), times.duration() / most_points));
  DelayedStep run(system, step);
  End end(system, times);
  ResponseCurve curve{{0.0}, {run.output()}};
  double before = run.output(), rise = 0.0;
  bool ends = end.is_at(0.0, before);
  for (double point = 1.0; !ends; point += 1.0) {
    run.advance();
    const double time = point * step, here = run.output();
    ends = end.is_at(time, here);
    if (rise * (here - before) < 0.0 && curve.x.back() < time - 1.5 * step) {
      curve.x.push_back(time - step);
      curve.y.push_back(before);
    }
    if (here != before) rise = here - before;
    before = here;
    if (time - curve.x.back() < times.spacing(time) * (1.0 - 1e-9) && !ends) continue;
    curve.x.push_back(time);
    curve.y.push_back(here);
  }
  return curve;
}

/// Other delays far below the step of the curve are replaced by lines: exact steps, a fraction of such a
/// delay each, would be without end.
ResponseCurve response_with_delays(const StateSpace& system) {
  constexpr double least_share = 0.02 / 800.0;
  constexpr Eigen::Index nodes = 4;
  if (const auto chain = delay_chain(system)) return later_response(*chain);
  const RowTimes times(system);
  const double shortest = least_share * times.duration();
  const bool has_short =
      std::ranges::any_of(system.delays, [&](const InnerDelay& delay) { return delay.time < shortest; });
  if (!has_short) return delayed_response(system, times);
  const StateSpace longer = with_lines_below(system, shortest, nodes);
  return longer.delays.empty() ? held_response(longer) : delayed_response(longer, times);
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
  return system.delays.empty() ? held_response(system) : response_with_delays(system);
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
