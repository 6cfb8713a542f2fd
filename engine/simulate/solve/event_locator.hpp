#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include "engine/simulate/solve/bracket.hpp"
#include "engine/simulate/solve/crossing_signs.hpp"
#include "engine/simulate/solve/event_task.hpp"
#include "engine/simulate/solve/ever_faster.hpp"
#include "engine/simulate/solve/left_of.hpp"

namespace stepwire::solve {

/// True if numbers have other bits than a copy of them.
inline bool have_changed(const double* numbers, const double* copy, std::size_t count) {
  return std::memcmp(numbers, copy, count * sizeof *numbers) != 0;
}

/// End of an interval: a tick, the edge of a source, or a time between them.
enum class Reach { tick, edge, inside };

/// Repeats a step of the solver from event to event. An event is an edge that a source has declared, or a
/// crossing: an instant at which a number changes its sign. 0 is a sign of its own. A crossing is bracketed
/// between two times, each the end of a solver step from the last event. The Illinois method (Dowell and
/// Jarratt 1971, BIT 11), with a bisection where it is slow, reduces the bracket to 1e-12 of the step or to
/// the last bit. The later time is the event.
///
/// Functions of a `Run`: advance(from, to, length) integrates the states of the workspace, with their
/// derivatives. Function follow() computes all that crossings depend on, crossings(numbers) the crossing
/// functions. Function edge() returns the time of the next edge, and begin() computes stage outputs and
/// derivatives and calls follow(). Function failed() is true after a failed step; forget_fault() resets it.
/// At an event, before(at) takes the values at the present time as those just before the instant `at`, and
/// begin_event() computes what guards read. Function round() computes outputs and updates, and returns true
/// if the run ends there by these outputs. Function after() does the same as begin() and returns true if the
/// run ends there.
template <class Run>
class EventLocator {
 public:
  EventLocator(const EventTask& task, double* values, const Run& run)
      : task_(task),
        values_(values),
        run_(run),
        x_(task.scratch),
        slopes_(x_ + task.state_count),
        start_(task.scratch + EventTask::before(task.state_count)),
        high_(start_ + task.crossing_count),
        low_(high_ + task.crossing_count),
        trial_(low_ + task.crossing_count),
        ever_faster_(trial_ + task.crossing_count, task.crossing_count),
        end_(trial_ + 7 * task.crossing_count),
        kept_(end_ + task.state_count),
        ends_(kept_ + task.numbers),
        nearest_(ends_ + task.crossing_count),
        looks_(nearest_ + task.crossing_count),
        control_(looks_ + task.crossing_count),
        start_guesses_(task.scratch + task.guesses()),
        end_guesses_(start_guesses_ + task.loops.count()) {}

  /// Integrates from `start` to `end` over `length`, event by event.
  void advance(double start, double end, double length, Reach reach = Reach::tick) {
    length_ = length;
    reach_ = reach;
    ever_faster_.begin(task_.crossing_count);
    std::copy_n(x_, task_.state_count, values_ + task_.states);
    task_.loops.restore(start_guesses_, values_);
    values_[task_.time] = start;
    run_.begin();
    keep();
    std::int64_t crossed = 0;
    double at = start;
    while (at < end && go_on(at, start, end, crossed)) continue;
    if (at == end && reach == Reach::tick) look_beyond(end);
    if (at == end) values_[task_.time] = end;
    double* report = values_ + task_.report;
    report[EventReport::events] += static_cast<double>(crossed);
    report[EventReport::most] = std::max(report[EventReport::most], static_cast<double>(crossed));
  }

  /// Repeats the discrete phase of a tick whose updates have changed states, until no number changes. A
  /// condition that such a state makes false is then false, and can become true again. Returns false if the
  /// run ends there.
  bool settle_tick(double length) {
    length_ = length;
    run_.begin_event();
    return settle();
  }

 private:
  /// Integrates from `at` to the next event or to the end. Returns false if the run ends there.
  bool go_on(double& at, double start, double end, std::int64_t& crossed) {
    const double from = at;
    edge_ = run_.edge();
    const bool at_edge =
        edge_ > from && (reach_ == Reach::edge ? edge_ <= end : edge_ < left_of(end, length_));
    at = at_edge ? edge_ : end;
    tick_ = reach_ == Reach::tick ? end : std::numeric_limits<double>::infinity();
    length_of_ = from == start && !at_edge ? length_ : at - from;
    go_back();
    go(from, at, length_of_, high_);
    const bool differs = sign_changes(start_, high_, task_.crossing_count);
    const bool crosses = crosses_inside(from, at) || differs;
    if (crosses) at = locate(from, at);
    if (at == end && !at_edge) return true;
    if (run_.failed()) return false;
    values_[task_.time] = at;
    if (crosses && !may_cross(crossed++, at)) return false;
    return act() && (!crosses || turn_back(at, end));
  }

  /// Moves the states at a tick beyond a crossing that follows at once, since it is one at the tick that
  /// rounding has delayed. At the last tick of a run it would else be missed.
  void look_beyond(double end) {
    const double little = after_tick * length_;
    if (run_.failed() || !almost_crosses(start_, high_, task_.crossing_count) || end + little == end) return;
    keep_end();
    std::copy_n(values_ + task_.control, task_.control_count, control_);
    std::copy_n(high_, task_.crossing_count, start_);
    values_[task_.time] = task_.jumps ? left_of(end, length_) : end;
    run_.begin();
    keep();
    go(end, end + little, little, high_);
    past().forget();
    if (!run_.failed() && sign_changes(start_, high_, task_.crossing_count))
      locate(end, end + little);
    else
      restore_end();
    run_.forget_fault();
    std::copy_n(control_, task_.control_count, values_ + task_.control);
    arrive(end, length_, high_);
  }

  /// Searches for crossings before `at` that the signs at both ends do not show: interpolates each state by a
  /// parabola, and confirms a sign change by a step of the solver. A number that turns back between two looks
  /// is followed to its turn.
  bool crosses_inside(double from, double& at) {
    keep_end();
    const bool failed = run_.failed();
    const double length = at - from;
    begin_looks();
    for (std::int64_t look = 1; look <= last_look(); ++look) {
      const double part = part_of(look) * length;
      interpolate(from, length, part_of(look));
      add_look(look);
      if (!sign_changes(start_, trial_, task_.crossing_count) || !crosses_at(from, part)) continue;
      at = from + part;
      return true;
    }
    if (crosses_at_turn(from, length, at)) return true;
    if (!failed) run_.forget_fault();
    restore_end();
    arrive(at, length_of_, high_);
    return false;
  }

  /// Keeps the states at the end of the interval, with the guesses of loops, from a search.
  void keep_end() {
    std::copy_n(values_ + task_.states, task_.state_count, end_);
    task_.loops.keep(values_, end_guesses_);
  }
  void restore_end() {
    std::copy_n(end_, task_.state_count, values_ + task_.states);
    task_.loops.restore(end_guesses_, values_);
  }

  /// The first and the last look are next to the ends, where they show numbers that turn before the next one.
  std::int64_t last_look() const { return task_.looks > 0 ? task_.looks + 2 : 0; }
  double part_of(std::int64_t look) const {
    constexpr double next_to = 1e-3;
    if (look == 1) return next_to;
    if (look == last_look()) return 1.0 - next_to;
    return static_cast<double>(look - 1) / static_cast<double>(task_.looks + 1);
  }

  /// Computes the crossing functions at a part of the interval, with each state on a parabola.
  void interpolate(double from, double length, double part) {
    for (std::size_t i = 0; i < task_.state_count; ++i) {
      const double straight = length * slopes_[i];
      values_[task_.states + i] = x_[i] + part * (straight + part * (end_[i] - x_[i] - straight));
    }
    values_[task_.time] = from + part * length;
    run_.follow();
    run_.crossings(trial_);
  }

  /// True if a step of the solver over a part of the interval crosses.
  bool crosses_at(double from, double part) {
    go_back();
    go(from, from + part, part, high_);
    return sign_changes(start_, high_, task_.crossing_count);
  }

  void begin_looks() {
    std::copy_n(high_, task_.crossing_count, ends_);
    std::copy_n(start_, task_.crossing_count, nearest_);
    std::fill_n(looks_, task_.crossing_count, 0.0);
  }
  /// Notes the look at which each number is nearest to 0.
  void add_look(std::int64_t look) {
    for (std::size_t i = 0; i < task_.crossing_count; ++i)
      if (std::abs(trial_[i]) < std::abs(nearest_[i])) {
        nearest_[i] = trial_[i];
        looks_[i] = static_cast<double>(look);
      }
  }

  /// Follows the numbers that are nearest to 0 between the ends of the interval. Returns true with the first
  /// time at which one has crossed. Each step of a solver with error control changes the length of the next
  /// one. So each step of the search begins with the same numbers of this control, and the order of the
  /// numbers changes no bit.
  bool crosses_at_turn(double from, double length, double& at) {
    std::copy_n(values_ + task_.control, task_.control_count, control_);
    double first = length;
    for (std::size_t i = 0; i < task_.crossing_count; ++i)
      if (looks_[i] > 0.0 && std::abs(nearest_[i]) < std::abs(ends_[i]) &&
          sign_of(ends_[i]) == sign_of(start_[i]))
        first = std::min(first, turn(i, from, length));
    const bool found = first != length && crosses_anew(from, first);
    std::copy_n(control_, task_.control_count, values_ + task_.control);
    if (found) at = from + first;
    return found;
  }
  bool crosses_anew(double from, double part) {
    std::copy_n(control_, task_.control_count, values_ + task_.control);
    return crosses_at(from, part);
  }

  /// Returns how long after the start a number has crossed near its turn; `length` if it does not. The turn
  /// is approached by parabolas through steps of the solver, while these predict a crossing within a part of
  /// their rise.
  double turn(std::size_t i, double from, double length) {
    constexpr int most = 4;
    const double side = start_[i] > 0.0 ? 1.0 : -1.0;
    bool crosses = false;
    const auto sample = [&](double part) {
      crosses = crosses || (part < length && crosses_anew(from, part));
      return Sample{part, side * (part < length ? high_[i] : ends_[i])};
    };
    const auto look = static_cast<std::int64_t>(looks_[i]);
    Sample middle = sample(part_of(look) * length);
    if (crosses) return middle.at;
    Sample low = look > 1 ? sample(part_of(look - 1) * length) : Sample{0.0, side * start_[i]};
    if (crosses) return low.at;
    Sample high = sample(look < last_look() ? part_of(look + 1) * length : length);
    if (crosses) return high.at;
    for (int k = 0; k < most; ++k) {
      const Sample vertex = lowest_of(low, middle, high);
      const double rise = std::max(low.value, high.value) - vertex.value;
      if (!(vertex.value <= 0.5 * rise) || vertex.at == middle.at) return length;
      const Sample found = sample(vertex.at);
      if (crosses) return found.at;
      if (found.value - vertex.value <= 0.1 * found.value) return length;
      take(found, low, middle, high);
    }
    return length;
  }

  /// Returns the lowest point of the parabola through three samples; the middle one if it is not the lowest
  /// of them.
  static Sample lowest_of(const Sample& low, const Sample& middle, const Sample& high) {
    const double before = middle.at - low.at, after = high.at - middle.at;
    const double down = (middle.value - low.value) / before, up = (high.value - middle.value) / after;
    const double bend = (up - down) / (before + after), tilt = down + bend * before;
    if (!(down <= 0.0 && up >= 0.0 && up > down)) return {middle.at, std::numeric_limits<double>::infinity()};
    const double by = -0.5 * tilt / bend;
    return {middle.at + by, middle.value + 0.5 * tilt * by};
  }
  /// Replaces one of three samples by a new one, so that the lowest one stays in the middle.
  static void take(const Sample& found, Sample& low, Sample& middle, Sample& high) {
    const bool before = found.at < middle.at;
    if (found.value < middle.value) {
      (before ? high : low) = middle;
      middle = found;
    } else {
      (before ? low : high) = found;
    }
  }

  /// Continues a little later after an event at which a number is on the wrong side by rounding. That is one
  /// beyond its crossing and reversed, such as of a bouncing ball, or one that a loop has brought back before
  /// its crossing, since it is solved again to its tolerance. Each repetition of the latter is four times as
  /// long. Returns false if the run ends there.
  bool turn_back(double& at, double end) {
    const bool beyond = crossed_on(high_), back = !task_.loops.empty() && crossed_on(low_);
    const double little =
        std::min(back ? std::ldexp(1e-9 * length_, 2 * turns_) : 1e-9 * length_, 0.5 * (end - at));
    const bool may = (beyond || back) && at + little != at;
    if (may) go(at, at + little, little, trial_);
    if (!may || !(crosses_from(high_, low_) || (back && crosses_from(low_, high_)))) {
      turns_ = 0;
      return true;
    }
    turns_ = back ? std::min(turns_ + 1, most_turns) : 0;
    at += little;
    values_[task_.time] = at;
    return act();
  }
  /// True if a number that has crossed has the sign of `side` after the event.
  bool crossed_on(const double* side) const {
    for (std::size_t i = 0; i < task_.crossing_count; ++i)
      if (sign_of(low_[i]) != sign_of(high_[i]) && sign_of(start_[i]) == sign_of(side[i])) return true;
    return false;
  }
  /// True if it has this sign, and that of `other` a little later.
  bool crosses_from(const double* side, const double* other) const {
    for (std::size_t i = 0; i < task_.crossing_count; ++i)
      if (sign_of(low_[i]) != sign_of(high_[i]) && sign_of(start_[i]) == sign_of(side[i]) &&
          sign_of(trial_[i]) == sign_of(other[i]))
        return true;
    return false;
  }

  CrossingPast past() const { return {values_ + task_.report + EventReport::count, task_.crossing_count}; }

  void keep() {
    std::copy_n(values_ + task_.states, task_.state_count, x_);
    std::copy_n(values_ + task_.derivatives, task_.state_count, slopes_);
  }

  /// Runs the event iteration of the present instant. Returns false if the run ends there.
  bool act() {
    past().forget();
    run_.before(values_[task_.time]);
    run_.begin_event();
    return settle();
  }
  bool settle() {
    const double* const place = values_ + task_.first;
    bool stops = false;  // a reset of this instant may take the condition of the end away in a later round
    for (std::int64_t round = 0; true; ++round) {
      std::copy_n(place, task_.numbers, kept_);
      stops = run_.round() || stops;
      const std::size_t same =
          static_cast<std::size_t>(std::mismatch(place, place + task_.numbers, kept_, is_same).first - place);
      if (same == task_.numbers) break;
      if (round == task_.rounds) {
        give_up(EventReport::unsettled, static_cast<double>(task_.first + same));
        return false;
      }
    }
    if (run_.after() || stops) {
      values_[task_.report + EventReport::stopped] = 1.0;
      return false;
    }
    run_.crossings(start_);
    keep();
    return true;
  }
  static bool is_same(double a, double b) { return a == b || (a != a && b != b); }

  /// False if a located crossing is one too many, or if the intervals shrink towards zero.
  bool may_cross(std::int64_t crossed, double at) {
    for (std::size_t i = 0; i < task_.crossing_count; ++i) {
      if (sign_of(high_[i]) == sign_of(start_[i])) continue;
      const bool ends = ever_faster_.add(i, high_[i] > start_[i], at, length_);
      if (!ends && crossed < task_.max_per_step) continue;
      give_up(ends ? EventReport::ever_faster : EventReport::too_many, static_cast<double>(i));
      return false;
    }
    return true;
  }

  void give_up(double why, double number) {
    values_[task_.report + EventReport::end] = why;
    values_[task_.report + EventReport::number] = number;
  }

  /// Integrates the states and computes the crossing functions at the end.
  void go(double from, double to, double length, double* numbers) {
    run_.advance(from, end_of(to, length), length);
    arrive(to, length, numbers);
  }
  void arrive(double to, double length, double* numbers) {
    values_[task_.time] = end_of(to, length);
    run_.follow();
    run_.crossings(numbers);
  }
  /// Returns the end of a step to a time: just before it at a tick and where a source jumps. Elsewhere both
  /// sides of an event have the same time.
  double end_of(double to, double length) const {
    const bool before = task_.jumps && (to >= tick_ || left_of(edge_, length) <= to);
    return before ? left_of(to, length) : to;
  }
  void go_back() {
    std::copy_n(x_, task_.state_count, values_ + task_.states);
    std::copy_n(slopes_, task_.state_count, values_ + task_.derivatives);
  }

  /// Weights of both ends of a bracket. Illinois rule: that of an end which is kept twice is halved, so that
  /// the next guess is nearer to it.
  struct Weights {
    void follow(bool moves_high) {
      double& kept = moves_high ? low : high;
      kept = moves_high == moved_high ? 0.5 * kept : 1.0;
      (moves_high ? high : low) = 1.0;
      moved_high = moves_high;
    }
    double low = 1.0, high = 1.0;
    std::optional<bool> moved_high{};
  };

  /// Returns the time just after the first detected crossing, with the states there. The crossing functions
  /// at the `end` are those of `high_`.
  double locate(double from, double end) {
    const double width = 1e-12 * length_;
    double low = from, high = end, wide = high - low;
    Weights weights;
    std::copy_n(start_, task_.crossing_count, low_);
    std::copy_n(high_, task_.crossing_count, ends_);
    for (int k = 0; high - low > width && std::nextafter(low, high) < high; ++k) {
      if (k % 4 == 0) wide = high - low;
      const bool is_slow = k % 4 == 3 && high - low > 0.25 * wide;
      const double at = is_slow ? low + 0.5 * (high - low) : guess(low, high, weights, width, k % 2 == 0);
      go_back();
      go(from, at, at - from, trial_);
      const bool at_high = sign_passes(start_, trial_, ends_, task_.crossing_count);
      (at_high ? high : low) = at;
      std::copy_n(trial_, task_.crossing_count, at_high ? high_ : low_);
      weights.follow(at_high);
    }
    run_.forget_fault();
    go_back();
    go(from, high, high - from, high_);
    return high;
  }

  /// Returns the first zero of the secants, at least half the width or one bit away from both ends.
  double guess(double low, double high, const Weights& weights, double width, bool at_once) const {
    const double first =
        first_secant(start_, low_, high_, task_.crossing_count, weights.low, weights.high, at_once);
    const double margin = std::min(0.5 * width, 0.25 * (high - low));
    const double at = std::clamp(low + first * (high - low), low + margin, high - margin);
    return std::clamp(at, std::nextafter(low, high), std::nextafter(high, low));
  }

  const EventTask& task_;
  double* values_;
  const Run& run_;
  double *x_, *slopes_;                    ///< after the last event
  double *start_, *high_, *low_, *trial_;  ///< crossing functions there, beyond, before, between
  EverFaster ever_faster_;
  double* end_;                            ///< States at the end of the interval.
  double* kept_;                           ///< Signals and states before an iteration.
  double* ends_;                           ///< Crossing functions at the end of the interval.
  double *nearest_, *looks_;               ///< Numbers nearest to 0, and their looks.
  double* control_;                        ///< Numbers of the error control before a search.
  double *start_guesses_, *end_guesses_;   ///< Guesses of loops at the start and at the end of the interval.
  double length_ = 0.0, length_of_ = 0.0;  ///< length of the step, and of the interval up to the next event
  double edge_ = 0.0, tick_ = 0.0;         ///< next edge of a source, and the tick at the end of the step
  Reach reach_ = Reach::tick;
  static constexpr int most_turns = 10;
  int turns_ = 0;  ///< Repetitions of turn_back() at one crossing.
};

}  // namespace stepwire::solve
