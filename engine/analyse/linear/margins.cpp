#include "engine/analyse/linear/margins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "engine/analyse/linear/delay_system.hpp"
#include "engine/analyse/linear/gain_at_rest.hpp"
#include "engine/analyse/linear/loop_gain.hpp"

namespace stepwire::linear {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

void add_real(double frequency, const Complex& value, std::vector<Crossing>& found) {
  constexpr double rounding = 1e-6;
  if (std::abs(value.imag()) <= rounding * std::abs(value.real()) && value.real() < 0.0 &&
      std::isfinite(value.real()))
    found.push_back({frequency, -1.0 / value.real()});
}

/// Finds the margins of a loop in its frequency response. Limits at 0, at half the sample frequency and at
/// infinity are added to the rows of the grid.
class MarginSearch {
 public:
  MarginSearch(const LoopGain& loop, double direct, Margins& margins)
      : loop_(loop), direct_(direct), margins_(margins) {}

  void find() {
    if (loop_.rows().empty()) return give_up("the loop has no finite gain at any frequency");
    find_gain();
    find_phase();
    find_modulus();
    if (!loop_.response().follows_all_turns()) bound_the_rest();
  }

 private:
  void find_gain() {
    const LoopGain::Negative found = loop_.negative();
    const auto& crossings = found.rows;
    const bool complete = loop_.response().follows_all_turns();
    margins_.gain_up_to = complete ? found.last : loop_.response().last_followed();
    margins_.gain_left_out = complete ? found.left_out : 0;
    const auto has = [&](double frequency) {
      return std::ranges::find(crossings, frequency, &LoopGain::Row::frequency) != crossings.end();
    };
    const double last = loop_.rows().back().frequency;
    if (!has(loop_.rows().front().frequency) && std::isfinite(loop_.at_rest()))
      add_real(0.0, loop_.at_rest(), margins_.gain);
    for (const LoopGain::Row& row : crossings)
      if (is_resolved(row.frequency)) add_real(row.frequency, row.value, margins_.gain);
    if (has(last)) return;
    if (loop_.response().is_sampled())
      add_real(last, loop_.rows().back().value, margins_.gain);
    else if (loop_.response().last_followed() == infinite)
      add_real(infinite, direct_, margins_.gain);
    else if (direct_ != 0.0 && loop_.response().follows_all_turns())  // its phase takes every value
      margins_.gain.push_back({infinite, 1.0 / std::abs(direct_)});
  }

  void find_phase() {
    for (const Crossover& crossover : loop_.crossovers())
      if (is_resolved(crossover.frequency))
        margins_.phase.push_back(
            {crossover.frequency, wrapped(std::numbers::pi + std::arg(loop_.at(crossover.frequency)))});
    const auto band = loop_.band_of_one();
    if (!band) return;
    margins_.knows_phase = false;
    margins_.notes.push_back(fmt::format(
        "the loop gain is 1 within rounding from {:.4g} to {:.4g} rad/s, so that the phase margin and "
        "the delay margin cannot be determined",
        band->from, band->to));
  }

  void find_modulus() {
    const LoopGain::Row nearest = loop_.nearest_to_minus_one();
    take(nearest.frequency, std::abs(1.0 + nearest.value));
    take(0.0, std::abs(1.0 + loop_.at_rest()));
    if (loop_.response().is_sampled()) return;
    const bool turns = loop_.response().last_followed() < infinite;
    if (!loop_.response().follows_all_turns() && direct_ != 0.0) return;  // a bound, no limit
    take(infinite, turns ? std::abs(1.0 - std::abs(direct_)) : std::abs(1.0 + direct_));
  }

  bool is_resolved(double frequency) const {
    return loop_.response().follows_all_turns() || frequency <= loop_.response().last_followed();
  }

  void take(double frequency, double distance) {
    const bool first = margins_.modulus_frequency < 0.0;
    // A limit counts where it is less by more than rounding.
    if (!first && !(distance < margins_.modulus * (1.0 - 1e-12))) return;
    if (!std::isfinite(distance)) return;
    margins_.modulus = distance;
    margins_.modulus_frequency = frequency;
  }

  /// Decides what the gain beyond the last resolved turn of parallel or inner delays can change.
  void bound_the_rest() {
    const double last = loop_.response().last_followed();
    double most = std::abs(direct_);
    for (const LoopGain::Row& row : loop_.rows())
      if (row.frequency >= last) most = std::max(most, loop_.response().bound(row.frequency));
    const auto worst = margins_.worst_gain();
    const double found = worst ? std::abs(std::log(worst->margin)) : infinite;
    constexpr double share = 1e-3;  // of a margin, which need not be better known
    margins_.knows_phase = margins_.knows_phase && most < 1.0;
    margins_.knows_gain = most == 0.0 || (most < 1.0 && -std::log(most) >= (1.0 - share) * found);
    margins_.knows_modulus = 1.0 - most >= (1.0 - share) * margins_.modulus;
    if (margins_.knows_gain && margins_.knows_phase && margins_.knows_modulus) return;
    margins_.notes.push_back(fmt::format(
        "the delays are resolved up to {:.4g} rad/s; beyond it the loop gain is at most {:.4g}, and what is "
        "nearer to the border there is not found",
        last, most));
  }

  void give_up(const std::string& why) {
    margins_.knows_gain = margins_.knows_phase = margins_.knows_modulus = false;
    margins_.notes.push_back(why);
  }

  const LoopGain& loop_;
  double direct_;
  Margins& margins_;
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

double margin_at(const std::optional<Crossing>& crossing, bool stable, bool known) {
  if (!known) return not_known;
  if (crossing) return crossing->margin;
  return stable ? infinite : not_known;
}

/// Decides whether the closed loop is stable, with all states.
void judge_stability(const StateSpace& closed, Margins& margins) {
  const Stability found = stability_of(closed);
  margins.stable = found.stable;
  margins.knows_stability = found.known;
  margins.hidden = found.hidden;
  if (!margins.knows_stability)
    margins.notes.push_back(
        "the growing modes of the closed loop could not be counted: a pole is on the border within rounding, "
        "the delays turn too often below the highest crossover, or delays without a common step feed each "
        "other with gains near 1; with whole multiples of one step in their place the last ones are counted");
}

/// Returns the first frequency beyond a grid at which a monotone function is negative; nan if `falls` but
/// none is found.
double first_below(const std::function<double(double)>& above, double from) {
  for (double w = from; w < 1e12 * from; w *= 10.0)
    if (above(10.0 * w) < 0.0) return find_zero(above, w, 10.0 * w);
  return infinite;
}

}  // namespace

std::optional<Crossing> Margins::worst_gain() const {
  return nearest(gain, stable, [](double margin) { return std::log(margin); });
}

std::optional<Crossing> Margins::worst_phase() const {
  return nearest(phase, stable, [](double margin) { return margin; });
}

double Margins::gain_margin() const {
  return margin_at(worst_gain(), stable, knows_gain && knows_stability);
}

double Margins::phase_margin() const {
  return margin_at(worst_phase(), stable, knows_phase && knows_stability);
}

double Margins::delay() const {
  if (!stable || !knows_phase) return not_known;
  double least = std::abs(direct) >= 1.0 - 1e-9 ? 0.0 : infinite;
  for (const Crossing& crossing : phase) {
    const double angle = crossing.margin < 0.0 ? crossing.margin + 2.0 * std::numbers::pi : crossing.margin;
    least = std::min(least, angle / crossing.frequency);
  }
  return least;
}

double Margins::modulus_margin() const {
  return stable && knows_modulus ? modulus : not_known;
}

Margins margins_of(const StateSpace& all, double feedback) {
  const StateSpace system = all.connected(), closed = system.closed(feedback);
  Margins margins;
  margins.modulus = infinite;
  margins.modulus_frequency = -1.0;
  std::vector<Mode> modes;
  if (closed.A.allFinite()) margins.closed_poles = poles_of(closed);
  for (const Complex& pole : margins.closed_poles) {
    const Complex s = closed.is_sampled() ? std::log(pole) / closed.sample_time : pole;
    if (std::abs(s) > 0.0 && std::isfinite(std::abs(s)))
      modes.push_back({pole, std::abs(s), -s.real() / std::abs(s)});
  }
  judge_stability(all.closed(feedback), margins);
  const LoopGain loop(system, -feedback, modes);
  if (!system.is_sampled())
    margins.direct = loop.response().follows_all_turns() ? -feedback * loop.response().direct_value()
                                                         : loop.response().direct_gain();
  MarginSearch(loop, margins.direct, margins).find();
  constexpr double rounding = 1e-9;  // also of derivatives by differences
  if (margins.modulus < rounding) margins.stable = false;
  return margins;
}

double bandwidth(const StateSpace& system) {
  const FrequencyResponse response(system);
  const double rest = std::abs(gain_at_rest(system));
  if (std::isnan(rest)) return not_known;
  if (!(rest > 0.0 && std::isfinite(rest))) return 0.0;
  const auto above = [&](double w) {
    return std::log(std::abs(response.at(w)) / rest) + 0.5 * std::log(2.0);
  };
  const std::vector<double> grid = response.search_frequencies({});
  double before = 0.0;
  for (std::size_t k = 0; k < grid.size(); before = grid[k++]) {
    if (above(grid[k]) < 0.0) return find_zero(above, before, grid[k]);
    if (k == 0 || k + 1 == grid.size() || above(grid[k]) > std::min(above(before), above(grid[k + 1])))
      continue;
    const CurvePoint least = find_minimum(above, before, grid[k + 1]);
    if (least.y < 0.0) return find_zero(above, before, least.x);
  }
  if (system.is_sampled()) return infinite;
  if (response.follows_all_turns()) return first_below(above, grid.back());
  return response.direct_gain() * std::sqrt(2.0) < rest ? not_known : infinite;
}

}  // namespace stepwire::linear
