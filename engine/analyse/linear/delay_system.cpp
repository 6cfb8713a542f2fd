#include "engine/analyse/linear/delay_system.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/analyse/linear/loop_gain.hpp"
#include "engine/analyse/linear/point_response.hpp"
#include "engine/analyse/linear/poles.hpp"

namespace stepwire::linear {
namespace {

/// Returns the system with wires in place of its delays. No loop of delays alone may exist.
StateSpace with_wires(const StateSpace& system) {
  const auto d = static_cast<Eigen::Index>(system.delays.size());
  const Eigen::Index p = std::ssize(system.outputs), m = std::ssize(system.inputs);
  const Eigen::MatrixXd inner = Eigen::MatrixXd::Identity(d, d) - system.D.bottomRightCorner(d, d);
  const Eigen::PartialPivLU<Eigen::MatrixXd> solver(inner);
  const Eigen::MatrixXd from_states = solver.solve(system.C.bottomRows(d)),
                        from_inputs = solver.solve(system.D.bottomLeftCorner(d, m));
  StateSpace wired = system;
  wired.delays.clear();
  wired.A = system.A + system.B.rightCols(d) * from_states;
  wired.B = system.B.leftCols(m) + system.B.rightCols(d) * from_inputs;
  wired.C = system.C.topRows(p) + system.D.topRightCorner(p, d) * from_states;
  wired.D = system.D.topLeftCorner(p, m) + system.D.topRightCorner(p, d) * from_inputs;
  return wired;
}

/// Returns the system from one column of B to one row of C, without delays and without unused states.
StateSpace part_between(const StateSpace& system, Eigen::Index column, Eigen::Index row) {
  return StateSpace{system.A,      system.B.col(column), system.C.row(row), system.D.block(row, column, 1, 1),
                    system.states, {{"", ""}},           {{"", ""}},        0.0}
      .connected();
}

/// True if a path from a column of B to a row of C passes no delay.
bool has_path(const StateSpace& system, Eigen::Index column, Eigen::Index row) {
  return system.D(row, column) != 0.0 || !part_between(system, column, row).states.empty();
}

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

/// Returns the number of steps of one common length in each delay; empty without such a length of which the
/// shortest delay has at most 16 and all together have at most 400.
std::vector<Eigen::Index> common_steps(const std::vector<InnerDelay>& delays) {
  constexpr double most_in_shortest = 16.0, most = 400.0, rounding = 1e-9;
  const double shortest = std::ranges::min(delays, {}, &InnerDelay::time).time;
  for (double in_shortest = 1.0; in_shortest <= most_in_shortest; in_shortest += 1.0) {
    std::vector<Eigen::Index> steps;
    double all = 0.0;
    for (const InnerDelay& delay : delays) {
      const double count = delay.time / shortest * in_shortest;
      if (std::abs(count - std::round(count)) > rounding * count || (all += count) > most) break;
      steps.push_back(std::lround(count));
    }
    if (steps.size() == delays.size()) return steps;
  }
  return {};
}

/// Returns the growth per step of what runs in the delays alone, which are lines of steps of one length.
double growth_in_lines(const Eigen::MatrixXd& direct, const std::vector<Eigen::Index>& steps) {
  std::vector<Eigen::Index> ends;
  Eigen::Index all = 0;
  for (const Eigen::Index count : steps) ends.push_back((all += count) - 1);
  Eigen::MatrixXd lines = Eigen::MatrixXd::Zero(all, all);
  for (Eigen::Index k = 0; k < direct.rows(); ++k) {
    const Eigen::Index last = ends[static_cast<std::size_t>(k)],
                       first = last + 1 - steps[static_cast<std::size_t>(k)];
    for (Eigen::Index i = first; i < last; ++i) lines(i + 1, i) = 1.0;
    for (Eigen::Index from = 0; from < direct.cols(); ++from)
      lines(first, ends[static_cast<std::size_t>(from)]) += direct(k, from);
  }
  double largest = 0.0;
  for (const Complex& value : eigenvalues(lines)) largest = std::max(largest, std::abs(value));
  return largest;
}

double radius_at(const Eigen::MatrixXd& direct, const std::vector<double>& phases) {
  Eigen::MatrixXcd turned = direct.cast<Complex>();
  for (Eigen::Index k = 0; k < turned.rows(); ++k)
    turned.row(k) *= std::polar(1.0, phases[static_cast<std::size_t>(k)]);
  return turned.eigenvalues().cwiseAbs().maxCoeff();
}

/// Returns the largest spectral radius of the direct gains over all phases of the delays, found by ascent
/// along each phase. For two delays it is the maximum, since only one phase counts; for more it may be less.
double radius_in_phase(const Eigen::MatrixXd& direct) {
  constexpr int places = 180, rounds = 12;
  constexpr std::size_t most_delays = 8;
  std::vector<double> phases(static_cast<std::size_t>(direct.rows()), 0.0);
  if (phases.size() > most_delays) return 0.0;
  double best = radius_at(direct, phases), width = std::numbers::pi;
  for (int round = 0; round < rounds; ++round, width *= round < 3 ? 1.0 : 0.25)
    for (std::size_t k = 1; k < phases.size(); ++k) {
      const double middle = phases[k];
      for (int place = -places; place <= places; ++place) {
        std::vector<double> tried = phases;
        tried[k] = middle + width * place / places;
        if (const double radius = radius_at(direct, tried); radius > best) {
          best = radius;
          phases = tried;
        }
      }
    }
  return best;
}

/// Returns whether what runs in the delays alone dies out: direct gains below 1 around each loop of them.
///
/// Delays without a common step take all phases, one after the other and nearly (Kronecker). So it grows if
/// the gains are above 1 for some phases, and dies out if they are below 1 for all (J. K. Hale, S. M. Verduyn
/// Lunel, "Introduction to functional differential equations", 1993, chapter 9.6). In between, or where the
/// phases of many delays are not searched, this is not known.
std::optional<bool> echoes_die(const StateSpace& system) {
  constexpr double rounding = 1e-12;
  const auto delays = std::ssize(system.delays);
  const Eigen::MatrixXd direct = system.D.bottomRightCorner(delays, delays);
  if (spectral_radius(direct.cwiseAbs()) < 1.0 - rounding) return true;
  const auto steps = common_steps(system.delays);
  if (!steps.empty()) return growth_in_lines(direct, steps) < 1.0 - rounding;
  if (delays == 1) return false;
  constexpr double clearly = 0.01;  // beyond the phases that delays with a step of few parts leave out
  const double radius = radius_in_phase(direct);
  if (radius > 1.0 + clearly) return false;
  return delays == 2 && radius < 1.0 - clearly ? std::optional(true) : std::nullopt;
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

std::optional<DelayChain> delay_chain(const StateSpace& system) {
  const auto d = static_cast<Eigen::Index>(system.delays.size());
  if (d == 0) return DelayChain{system, 0.0};
  // Node 0 is the source of paths (input or end of a delay) and their target (output or start of a delay).
  std::vector<char> passed(static_cast<std::size_t>(d) + 1, 0);
  double time = 0.0;
  Eigen::Index here = 0;
  for (Eigen::Index count = 0; count <= d; ++count) {
    Eigen::Index next = -1;
    for (Eigen::Index row = 0; row <= d; ++row) {
      if (!has_path(system, here, row)) continue;
      if (next >= 0) return std::nullopt;
      next = row;
    }
    if (next < 0 || std::exchange(passed[static_cast<std::size_t>(next)], 1)) return std::nullopt;
    if (next > 0) time += system.delays[static_cast<std::size_t>(next - 1)].time;
    here = next;
    if (here == 0) break;
  }
  if (here != 0 || std::ranges::count(passed, 1) != d + 1) return std::nullopt;
  return DelayChain{with_wires(system).connected(), time};
}

StateSpace around_delay(const StateSpace& system, std::size_t delay) {
  const auto m = std::ssize(system.inputs), p = std::ssize(system.outputs);
  std::vector<Eigen::Index> columns{m + static_cast<Eigen::Index>(delay)},
      rows{p + static_cast<Eigen::Index>(delay)};
  StateSpace around = system;
  around.delays.clear();
  for (std::size_t k = 0; k < system.delays.size(); ++k) {
    if (k == delay) continue;
    columns.push_back(m + static_cast<Eigen::Index>(k));
    rows.push_back(p + static_cast<Eigen::Index>(k));
    around.delays.push_back(system.delays[k]);
  }
  around.inputs = {system.delays[delay].in};
  around.outputs = {system.delays[delay].out};
  around.B = system.B(Eigen::all, columns);
  around.C = system.C(rows, Eigen::all);
  around.D = system.D(rows, columns);
  return around;
}

StateSpace with_loops_only(const StateSpace& system) {
  std::vector<Eigen::Index> columns, rows;
  StateSpace part = system;
  part.delays.clear();
  for (std::size_t i = 0; i < system.inputs.size(); ++i) columns.push_back(static_cast<Eigen::Index>(i));
  for (std::size_t o = 0; o < system.outputs.size(); ++o) rows.push_back(static_cast<Eigen::Index>(o));
  for (std::size_t k = 0; k < system.delays.size(); ++k) {
    const StateSpace around = around_delay(system, k).connected();
    if (around.states.empty() && around.delays.empty() && around.D(0, 0) == 0.0) continue;
    columns.push_back(std::ssize(system.inputs) + static_cast<Eigen::Index>(k));
    rows.push_back(std::ssize(system.outputs) + static_cast<Eigen::Index>(k));
    part.delays.push_back(system.delays[k]);
  }
  part.B = system.B(Eigen::all, columns);
  part.C = system.C(rows, Eigen::all);
  part.D = system.D(rows, columns);
  return part;
}

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

std::optional<int> count_unstable(const StateSpace& system) {
  const StateSpace loops = with_loops_only(system);
  if (loops.delays.empty()) return count_right(system.A);
  const auto die = echoes_die(loops);
  if (die == false) return infinitely_many;
  if (die && system.A.rows() == 0) return 0;
  bool is_one = false;
  const auto count = count_if_one_loop(loops, is_one);
  return is_one ? count : count_by_turns(loops, scales_of(loops));
}

}  // namespace stepwire::linear
