// Number of unstable poles of a system with delays.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analyse/linear/delay_system.hpp"
#include "engine/analyse/linear/loop_gain.hpp"
#include "engine/analyse/linear/point_response.hpp"
#include "engine/analyse/linear/poles.hpp"

namespace stepwire::linear {

namespace {

/// Follows the angle of the determinant along a line near the imaginary axis. Intervals are halved until the
/// angle between their ends is below 0.5 rad and unambiguous.
class Turns {
 public:
  /// An interval has at most 2 rad of all delays together, whose sum is `delay` [s].
  Turns(const PointResponse& response, double beside, double delay)
      : response_(response), beside_(beside), widest_(2.0 / delay) {}

  /// Returns the change of the angle between two frequencies [rad]; std::nullopt if the determinant passes 0,
  /// or after too many points.
  std::optional<double> between(double low, double high) { return between(low, at(low), high, at(high), 0); }
  Complex at(double frequency) {
    ++points_;
    return response_.return_difference({beside_, frequency});
  }

 private:
  static constexpr int most_points = 100'000;

  std::optional<double> between(double low, const Complex& first, double high, const Complex& last,
                                int depth) {
    const Complex ratio = last / first;
    if (!std::isfinite(std::abs(ratio)) || ratio == 0.0 || points_ > most_points) return std::nullopt;
    const double middle = 0.5 * (low + high);
    if (depth > 50 || !(middle > low && middle < high)) return std::nullopt;
    const Complex half = at(middle);
    const double whole = std::arg(ratio), parts = std::arg(half / first) + std::arg(last / half);
    if (high - low < widest_ && std::abs(whole) < 0.5 && std::abs(parts - whole) < 1e-9 &&
        std::abs(half / first - 1.0) < 0.7)
      return whole;
    const auto left = between(low, first, middle, half, depth + 1);
    const auto right = left ? between(middle, half, high, last, depth + 1) : left;
    if (!right) return std::nullopt;
    return *left + *right;
  }

  const PointResponse& response_;
  double beside_, widest_;
  int points_ = 0;
};

/// Returns the largest size of an eigenvalue.
double spectral_radius(const Eigen::MatrixXd& sizes) {
  return sizes.eigenvalues().cwiseAbs().maxCoeff();
}

/// True if the loops through delays have gains below 1 from a frequency on, whatever the turns of the delays.
/// X is the gain from delay to delay there, `direct` its limit. Either norm is enough. The radius of the
/// sizes also sees that a way from one delay to the next is no loop.
bool stays_below_one(const Eigen::MatrixXcd& X, const Eigen::MatrixXd& direct) {
  constexpr double most = 0.999;
  if (X.operatorNorm() < most && direct.operatorNorm() < most) return true;
  return spectral_radius(X.cwiseAbs().cwiseMax(direct.cwiseAbs())) < most;
}

/// Returns the angle of det(1 - X) for eigenvalues of X below 1.
double angle_from_one(const Eigen::MatrixXcd& X) {
  double angle = 0.0;
  for (const Complex& value : X.eigenvalues()) angle += std::arg(1.0 - value);
  return angle;
}

/// Frequencies [rad/s] between which a loop of delays changes. Beyond `settled` its gain is below 1.
struct Scales {
  double slowest = 0.0, fastest = 0.0, settled = 0.0;
  double delay = 0.0;  ///< Sum of the delays [s].
};

Scales scales_of(const StateSpace& system) {
  double all = 0.0, shortest = std::numeric_limits<double>::infinity();
  for (const InnerDelay& delay : system.delays) all += delay.time, shortest = std::min(shortest, delay.time);
  Scales scales{1.0 / all, 1.0 / shortest, 0.0, all};
  for (const Complex& pole : eigenvalues(system.A)) {
    if (std::abs(pole) > 1e-12 * scales.fastest) scales.slowest = std::min(scales.slowest, std::abs(pole));
    scales.fastest = std::max(scales.fastest, std::abs(pole));
  }
  scales.settled = 10.0 * scales.fastest;
  return scales;
}

/// Counts by the argument principle: the determinant det(1 - exp(-s T) G(s)) turns about 0 along the axis. G
/// is the system between its delays.
std::optional<int> count_by_turns(const StateSpace& system, const Scales& scales) {
  const double scale = scales.settled > 0.0 ? std::min(scales.fastest, scales.settled) : scales.slowest;
  const double beside = -std::max(1e-9 * scale, 1e-15 * scales.fastest);
  const PointResponse response(system);
  const auto delays = std::ssize(system.delays);
  const Eigen::MatrixXd direct = system.D.bottomRightCorner(delays, delays);
  if (!stays_below_one(direct.cast<Complex>(), direct)) return std::nullopt;
  Turns turns(response, beside, scales.delay);
  double turned = 0.0, low = 0.0;
  std::optional<double> rest;
  for (double high = 1e-3 * scales.slowest; !rest; low = high, high *= 1.1) {
    if (high > 1e9 * std::max(scales.fastest, scales.settled)) return std::nullopt;
    const auto more = turns.between(low, high);
    if (!more) return std::nullopt;
    turned += *more;
    if (high <= scales.settled) continue;
    const Eigen::MatrixXcd around = response.around({beside, high});
    if (stays_below_one(around, direct)) rest = angle_from_one(around);
  }
  const auto right =
      std::ranges::count_if(eigenvalues(system.A), [&](const Complex& pole) { return pole.real() > beside; });
  const double count = static_cast<double>(right) - (turned - *rest) / std::numbers::pi;
  if (std::abs(count - std::round(count)) > 0.05) return std::nullopt;
  return static_cast<int>(std::lround(count));
}

/// Returns the number of delays above `from` and up to `to` [s] for which a pole is on the imaginary axis at
/// a crossover; std::nullopt if one of them is `to` within rounding.
std::optional<double> crossings_between(double from, double to, double frequency, double angle) {
  const double turn = 2.0 * std::numbers::pi;
  const double first = (frequency * from - angle) / turn, last = (frequency * to - angle) / turn;
  const double rounding = 1e-9 + 1e-15 * last;
  if (std::abs(last - std::round(last)) < rounding || std::abs(first - std::round(first)) < rounding)
    return std::nullopt;
  return std::floor(last) - std::floor(first);
}

/// One loop through all delays of a system: 1 = X(s) exp(-s T).
struct DelayLoop {
  const StateSpace& system;
  LoopGain gain;  ///< X.
  double time = 0.0;
  std::vector<Crossover> crossovers;

  /// Returns the system with all delays scaled to the sum `sum` [s].
  StateSpace with_delay(double sum) const {
    StateSpace scaled = system;
    for (InnerDelay& delay : scaled.delays) delay.time *= sum / time;
    return scaled;
  }
};

/// Returns the change of the number while the delay grows; std::nullopt if a pole is on the axis at an end.
std::optional<double> crossed(const DelayLoop& loop, double from) {
  double sum = 0.0;
  for (const Crossover& crossover : loop.crossovers) {
    const double angle = std::arg(loop.gain.at(crossover.frequency));
    const auto more = crossings_between(from, loop.time, crossover.frequency, angle);
    if (!more) return std::nullopt;
    sum += (crossover.falls ? 2.0 : -2.0) * *more;
  }
  return sum;
}

/// Counts the poles of one loop by the direct method of K. Walton and J. E. Marshall ("Direct method for TDS
/// stability analysis", IEE Proceedings D 134, 1987). Poles are counted by turns for a short delay. While the
/// delay grows to T, a pair of poles crosses the axis at each crossover |X| = 1, again and again. It crosses
/// to the right where the gain falls, and to the left where it rises. The cost does not depend on T.
std::optional<int> count_in_one_loop(const DelayLoop& loop) {
  constexpr double few_turns = 300.0, most = 1e9;  // [rad]
  double highest = 0.0;
  for (const Crossover& crossover : loop.crossovers) highest = std::max(highest, crossover.frequency);
  const bool is_short = highest * loop.time <= few_turns;
  for (const double part : {1.0, 0.93, 0.81}) {
    const double time = is_short ? loop.time : part * few_turns / highest;
    Scales scales = scales_of(loop.with_delay(time));
    scales.settled = highest;
    const auto count = count_by_turns(loop.with_delay(time), scales);
    if (is_short) return count;
    if (const auto more = count ? crossed(loop, time) : std::nullopt)
      return static_cast<int>(std::min(*count + *more, most));
  }
  return std::nullopt;
}

/// Counts if one loop goes through all delays. Its gain must be 1 at single frequencies only.
std::optional<int> count_if_one_loop(const StateSpace& system, bool& is_one) {
  const StateSpace around = around_delay(system, 0).connected();
  const auto chain = delay_chain(around);
  is_one = chain && around.delays.size() + 1 == system.delays.size();
  if (!is_one) return std::nullopt;
  const LoopGain gain(chain->rational, 1.0);
  if (gain.band_of_one() || std::abs(chain->rational.D(0, 0)) >= 1.0 - 1e-9) return std::nullopt;
  return count_in_one_loop({system, gain, chain->time + system.delays[0].time, gain.crossovers()});
}

/// Returns the number of poles of a system without delays that are not on the left.
int count_right(const Eigen::MatrixXd& A) {
  const std::vector<Complex> poles = eigenvalues(A);
  double largest = 0.0;
  for (const Complex& pole : poles) largest = std::max(largest, std::abs(pole));
  return static_cast<int>(
      std::ranges::count_if(poles, [&](const Complex& pole) { return !(pole.real() < -1e-12 * largest); }));
}

}  // namespace

std::optional<int> count_unstable(const StateSpace& system) {
  const StateSpace loops = with_loops_only(system);
  if (loops.delays.empty()) return count_right(system.A);
  bool is_one = false;
  const auto count = count_if_one_loop(loops, is_one);
  return is_one ? count : count_by_turns(loops, scales_of(loops));
}

}  // namespace stepwire::linear
