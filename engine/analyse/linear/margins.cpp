#include "engine/analyse/linear/margins.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace stepwire::linear {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Finds the zero of a function between two frequencies with different signs, by bisection.
double root(const std::function<double(double)>& function, double low, double high) {
  const bool rises = function(low) < 0.0;
  for (int k = 0; k < 200 && high - low > 4e-16 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (((function(middle) < 0.0) == rises) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// The frequency response of a loop on a grid, and its crossings. The grid resolves every pole, zero and turn
/// of a delay, and reaches as far as the gain may cross 1. A change of sign between two rows of the imaginary
/// part, or of |L| - 1, brackets a crossing. Bisection refines it. Limits at 0, at half the sample frequency
/// and at infinity are added separately.
class Loop {
 public:
  Loop(const StateSpace& system, double feedback) : response_(system), sign_(-feedback) {
    for (const double w : response_.frequencies_across_one()) rows_.push_back({w, at(w)});
  }

  Complex at(double frequency) const { return sign_ * response_.at(frequency); }

  std::vector<Crossing> gain_margins(const StateSpace& system) const {
    std::vector<Crossing> found;
    add_real(0.0, at(0.0), found);
    for (std::size_t k = 0; k + 1 < rows_.size(); ++k) {
      const double a = rows_[k].value.imag(), b = rows_[k + 1].value.imag();
      if ((a < 0.0) == (b < 0.0) || is_rounding(rows_[k]) || is_rounding(rows_[k + 1])) continue;
      const double w =
          root([&](double f) { return at(f).imag(); }, rows_[k].frequency, rows_[k + 1].frequency);
      const Complex value = at(w);
      // The sign also changes at a pole on the axis.
      if (is_real(value, 1e-6)) add_real(w, value, found);
    }
    if (system.is_sampled()) {
      add_real(rows_.back().frequency, rows_.back().value, found);
    } else if (system.delays.empty()) {
      add_real(infinite, sign_ * system.D(0, 0), found);
    } else {
      add_not_followed(found);
      if (const double direct = direct_gain(system); direct > 0.0) found.push_back({infinite, 1.0 / direct});
    }
    return found;
  }

  std::vector<Crossing> phase_margins() const {
    std::vector<Crossing> found;
    const auto gain = [&](double f) { return std::log(std::abs(at(f))); };
    for (std::size_t k = 0; k + 1 < rows_.size(); ++k) {
      const double a = std::abs(rows_[k].value), b = std::abs(rows_[k + 1].value);
      if ((a < 1.0) == (b < 1.0)) continue;
      const double w = root(gain, rows_[k].frequency, rows_[k + 1].frequency);
      found.push_back({w, wrapped(std::numbers::pi + std::arg(at(w)))});
    }
    return found;
  }

  /// Finds the least |1 + L| by ternary search about the least row.
  void find_modulus(Margins& margins) const {
    const auto distance = [&](double f) { return std::abs(1.0 + at(f)); };
    std::size_t least = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (std::abs(1.0 + rows_[k].value) < std::abs(1.0 + rows_[least].value)) least = k;
    double low = rows_[least > 0 ? least - 1 : 0].frequency;
    double high = rows_[std::min(least + 1, rows_.size() - 1)].frequency;
    for (int k = 0; k < 100; ++k) {
      const double first = low + (high - low) / 3.0, second = high - (high - low) / 3.0;
      (distance(first) < distance(second) ? high : low) = distance(first) < distance(second) ? second : first;
    }
    margins.modulus_frequency = 0.5 * (low + high);
    margins.modulus = distance(margins.modulus_frequency);
  }

 private:
  struct Row {
    double frequency;
    Complex value;
  };

  /// Adds a worst case beyond the last resolved turn of the delays: the loop is taken as real and negative at
  /// its largest value.
  void add_not_followed(std::vector<Crossing>& found) const {
    const Row* largest = nullptr;
    for (const Row& row : rows_)
      if (row.frequency >= response_.last_followed() &&
          (largest == nullptr || std::abs(row.value) > std::abs(largest->value)))
        largest = &row;
    if (largest != nullptr) found.push_back({largest->frequency, 1.0 / std::abs(largest->value)});
  }
  /// Returns a bound of the gain at infinite frequency, by direct paths and paths through delays.
  static double direct_gain(const StateSpace& system) {
    const Eigen::MatrixXd D = system.D.cwiseAbs();
    const Eigen::Index d = D.rows() - 1;
    const double around = D.bottomRightCorner(d, d).operatorNorm();
    const double ways = D.row(0).tail(d).norm() * D.col(0).tail(d).norm();
    return D(0, 0) + (around < 1.0 ? ways / (1.0 - around) : ways > 0.0 ? infinite : 0.0);
  }

  static bool is_real(const Complex& value, double share) {
    return std::abs(value.imag()) <= share * std::abs(value.real());
  }
  /// True far from all corners if the loop is so nearly real that its imaginary part is rounding error.
  bool is_rounding(const Row& row) const {
    const auto [first, last] = response_.range();
    return (row.frequency < first || row.frequency > last) && is_real(row.value, 1e-7);
  }
  static void add_real(double frequency, const Complex& value, std::vector<Crossing>& found) {
    if (is_real(value, 1e-6) && value.real() < 0.0 && std::isfinite(value.real()))
      found.push_back({frequency, -1.0 / value.real()});
  }

  FrequencyResponse response_;
  double sign_;
  std::vector<Row> rows_;
};

/// Returns the crossing nearest to 0 in `size`; for an unstable loop only negative ones count.
template <class Size>
std::optional<Crossing> nearest(const std::vector<Crossing>& all, bool stable, Size size) {
  std::optional<Crossing> found;
  for (const Crossing& crossing : all)
    if (stable || size(crossing.margin) < 0.0)
      if (!found || std::abs(size(crossing.margin)) < std::abs(size(found->margin))) found = crossing;
  return found;
}

}  // namespace

std::optional<Crossing> Margins::worst_gain() const {
  return nearest(gain, stable, [](double margin) { return std::log(margin); });
}

std::optional<Crossing> Margins::worst_phase() const {
  return nearest(phase, stable, [](double margin) { return margin; });
}

double Margins::delay() const {
  if (!stable) return std::numeric_limits<double>::quiet_NaN();
  double least = infinite;
  for (const Crossing& crossing : phase) {
    const double angle = crossing.margin < 0.0 ? crossing.margin + 2.0 * std::numbers::pi : crossing.margin;
    least = std::min(least, angle / crossing.frequency);
  }
  return least;
}

namespace {

/// Returns the fastest growing mode of all states, beyond rounding; std::nullopt if no mode grows.
std::optional<Complex> growing(const StateSpace& closed) {
  constexpr double rounding = 1e-8;
  std::optional<Complex> found;
  double largest = 0.0, fastest = 0.0;
  const std::vector<Complex> poles = poles_of(closed);
  for (const Complex& pole : poles) largest = std::max(largest, std::abs(pole));
  for (const Complex& pole : poles) {
    const double growth = closed.is_sampled() ? std::abs(pole) - 1.0 : pole.real();
    if (growth <= rounding * (closed.is_sampled() ? 1.0 : largest) || growth <= fastest) continue;
    fastest = growth;
    found = pole;
  }
  return found;
}

}  // namespace

Margins margins_of(const StateSpace& all, double feedback) {
  const StateSpace system = all.connected();
  const Loop loop(system, feedback);
  Margins margins;
  margins.gain = loop.gain_margins(system);
  margins.phase = loop.phase_margins();
  loop.find_modulus(margins);
  const StateSpace closed = system.closed(feedback);
  if (closed.A.allFinite()) margins.closed_poles = poles_of(closed);
  margins.stable = is_stable(closed);
  if (!margins.stable || system.states.size() == all.states.size()) return margins;
  margins.hidden = growing(all.closed(feedback));
  margins.stable = !margins.hidden;
  return margins;
}

double gain_at_rest(const StateSpace& system) {
  return FrequencyResponse(system).at_rest();
}

double bandwidth(const StateSpace& system) {
  const FrequencyResponse response(system);
  const double rest = std::abs(gain_at_rest(system));
  if (!(rest > 0.0 && std::isfinite(rest))) return 0.0;
  const auto above = [&](double w) {
    return std::log(std::abs(response.at(w)) / rest) + 0.5 * std::log(2.0);
  };
  double before = 0.0;
  for (const double w : response.frequencies()) {
    if (above(w) < 0.0) return root(above, before, w);
    before = w;
  }
  return infinite;
}

}  // namespace stepwire::linear
