#pragma once

#include <cmath>

#include "engine/base/expression/language.hpp"  // for guards that are code
#include "engine/base/math/function.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/tree.hpp"
#include "engine/model/signal/texts.hpp"

namespace stepwire {

/// Finite state machine: nested states with output values, counters that they set, and transitions with
/// guards.
template <class Function>
struct StateMachineOf {
  static constexpr Index max_inputs = 64, max_counters = 32, max_depth = 8, max_states = 256;

  Tree states, counters;
  Texts variables{};
  Text initial;
  Inputs u{};
  Output<1> state{};
  Output<> y{}, counts{};
  DiscreteState<1> active{}, begun{};        // Active state; 0 before the first tick, then 1.
  DiscreteState<1> last_tick{}, moved_at{};  // Times of the last tick and of the last transition [s].
  // Times of the last update, and the last at which the part of a located machine was active [s]. They differ
  // after a part has been switched off between two ticks.
  DiscreteState<1> acted_at{}, seen_at{};
  // Ticks in the active state and its holders, outermost first. An entry between two ticks counts from the
  // first of them, and is later than it by `late` [s].
  DiscreteState<> ticks{}, late{};
  DiscreteState<> kept{};  // Values of the counters.
  DiscreteState<> past{};  // Last active inner state of each state, -1 for none.

  Function guard{};   ///< Guard of transition v[choice]; its variables are u1, u2, ..., counters, time in the
                      ///< state, choice.
  Function margin{};  ///< Same variables; passes 0 where the guard becomes true.
  Function setting{};                      ///< Value of setting v[choice].
  Numbers values{};                        ///< Output y of the first state, of the second, ...
  Numbers parent{}, inner{}, history{};    ///< Of each state: outer (-1: none), initial inner, history.
  Numbers first_to{}, target{};            ///< First transition of each state; target of each transition.
  Numbers first_setting{}, set_counter{};  ///< First settings of enter, exit, each, transitions; counters.
  Numbers first_counts{};                  ///< Initial values of the counters.
  Index first = 0, levels = 1;
  Index located = 1;  ///< Largest number of transitions of a state and those that hold it.
  bool remembers = false, sets = false;

  void outputs() {
    Now now = next(is_tick());
    state = static_cast<double>(now.leaf);
    const double* const here = values.data() + now.leaf * y.size();
    y.each([&](Index i) { return here[i]; });
    for (Index c = 0; c < counts.size(); ++c) counts[c] = first_counts.empty() ? 0.0 : now.v[u.count() + c];
  }

  void update() {
    const Now now = next(true);
    const bool was_off = left_between();
    for (Index l = 0; l < ticks.size(); ++l) {
      const bool stays = !now.entered[l];
      if (was_off && stays) late[l] = period.times(ticks[l]) - now.after[l];
      ticks[l] = l > depth(now.leaf) ? 0.0 : stays ? ticks[l] + 1.0 : 1.0;
      late[l] = stays && l <= depth(now.leaf) ? double(late[l]) : 0.0;
    }
    remember(now);
    last_tick = time;
  }
  void update_at_event() {
    const Now now = next(false);
    const bool was_off = begun != 0.0 && has_been_off();
    if (begun == 0.0 || was_off) last_tick = std::floor(time / period) * period;  // begins between ticks
    for (Index l = 0; l < ticks.size(); ++l) {
      const bool stays = begun != 0.0 && l <= depth(now.leaf) && !now.entered[l];
      if (stays && was_off) late[l] = period.times(ticks[l] - 1.0) + (time - last_tick) - now.after[l];
      if (stays) continue;
      ticks[l] = l > depth(now.leaf) ? 0.0 : 1.0;
      late[l] = l > depth(now.leaf) ? 0.0 : time - last_tick;
    }
    remember(now);
  }

  void crossings(Crossings& zero) const {
    Now now = present();
    Index added = 0;
    for (Index l = 0; l <= depth(now.leaf); ++l) {
      const Index s = holder(now.leaf, l);
      now.v[place_of_time()] = now.after[l] - hair();
      for (Index t = at(first_to, s); t < at(first_to, s + 1); ++t, ++added) {
        now.v[place_of_time() + 1] = static_cast<double>(t);
        zero.add(margin(now.v));
      }
    }
    for (; added < located; ++added) zero.add(1.0);
  }

  void start() {
    active = static_cast<double>(first);
    for (Index c = 0; c < first_counts.size(); ++c) kept[c] = first_counts[c];
    past = -1.0;
    moved_at = acted_at = seen_at = -1.0;
  }
  void configure(Configure& is);
  static void declare(Declare<StateMachineOf>& is);

 private:
  /// State of the machine at an instant, before or after its transition.
  struct Now {
    Index leaf;
    double v[max_inputs + max_counters + 2];
    double after[max_depth];         ///< time since the states were entered, outermost first [s]
    bool entered[max_depth], moved;  ///< by a transition of this instant
    double past[max_states];
  };
  enum Kind { enter, exit, each };

  static Index at(const Numbers& numbers, Index i) { return static_cast<Index>(numbers[i]); }
  Index depth(Index s) const {
    Index depth = 0;
    for (s = at(parent, s); s >= 0; s = at(parent, s)) ++depth;
    return depth;
  }
  Index holder(Index s, Index level) const {
    for (Index l = depth(s); l > level; --l) s = at(parent, s);
    return s;
  }
  bool holds(Index s, Index other) const {
    for (other = at(parent, other); other >= 0; other = at(parent, other))
      if (other == s) return true;
    return false;
  }
  Index place_of_time() const { return u.count() + first_counts.size(); }

  /// True at a tick before its update.
  bool is_tick() const {
    if (begun != 0.0 && seen_at >= 0.0 && has_been_off())
      return std::abs(time - std::round(time / period) * period) <= rounding();
    return reaches_tick();
  }
  bool reaches_tick() const { return begun == 0.0 || time - last_tick >= period - rounding(); }
  /// True if its part was switched off between two ticks, and has just become active again.
  bool left_between() const { return seen_at > acted_at && seen_at < time; }
  /// True where its part has just become active again.
  bool has_been_off() const { return left_between() || time - last_tick > period + rounding(); }
  /// Returns the rounding of a difference of times [s].
  double rounding() const { return 2e-15 * time; }
  /// Returns the delay of crossings [s]. A time in a state that ends on a tick acts at this tick, not just
  /// before.
  double hair() const { return 1e-12 * period + 2.0 * rounding(); }
  double time_in(Index level) const {
    if (left_between()) return period.times(ticks[level] - 1.0) + (seen_at - last_tick) - late[level];
    if (reaches_tick()) return period.times(ticks[level]) - late[level];
    return period.times(ticks[level] - 1.0) + (time - last_tick) - late[level];
  }

  Now present() const {
    Now now;
    now.leaf = static_cast<Index>(active);
    now.moved = false;
    for (Index i = 0; i < u.count(); ++i) now.v[i] = u.first(i);
    for (Index c = 0; c < first_counts.size(); ++c) now.v[u.count() + c] = kept[c];
    for (Index l = 0; l < ticks.size(); ++l) {
      now.after[l] = time_in(l);
      now.entered[l] = false;
    }
    if (remembers)
      for (Index s = 0; s < past.size(); ++s) now.past[s] = past[s];
    return now;
  }

  /// Returns the state after the transition of this instant, if any. An instant has one at most.
  Now next(bool at_tick) {
    Now now = present();
    if (sets && begun == 0.0)
      for (Index l = 0; l <= depth(now.leaf); ++l) run(now, 3 * holder(now.leaf, l) + enter, 0.0);
    now.moved = moved_at != time && moves(now);
    if (!now.moved && sets && at_tick)
      for (Index l = 0; l <= depth(now.leaf); ++l) run(now, 3 * holder(now.leaf, l) + each, now.after[l]);
    return now;
  }

  void remember(const Now& now) {
    active = static_cast<double>(now.leaf);
    for (Index c = 0; c < first_counts.size(); ++c) kept[c] = now.v[u.count() + c];
    if (remembers)
      for (Index s = 0; s < past.size(); ++s) past[s] = now.past[s];
    if (now.moved) moved_at = time;
    acted_at = time;
    begun = 1.0;
  }

  /// Takes the first transition whose guard holds; those of the outermost state have precedence. Returns
  /// false without one.
  bool moves(Now& now) {
    const Index time_place = place_of_time();
    for (Index l = 0; l < levels; ++l) {
      if (l > depth(now.leaf)) return false;
      const Index s = holder(now.leaf, l);
      now.v[time_place] = now.after[l];
      for (Index t = at(first_to, s); t < at(first_to, s + 1); ++t) {
        now.v[time_place + 1] = static_cast<double>(t);
        if (guard(now.v) == 0.0) continue;
        take(now, s, t);
        return true;
      }
    }
    return false;
  }

  void take(Now& now, Index from, Index t) {
    Index common = at(parent, from);  // stays active
    Index to = at(target, t);
    while (common >= 0 && !holds(common, to)) common = at(parent, common);
    for (Index s = now.leaf; s != common; s = at(parent, s)) {
      if (sets) run(now, 3 * s + exit, now.after[depth(s)]);
      if (remembers && at(parent, s) >= 0) now.past[at(parent, s)] = static_cast<double>(s);
    }
    if (sets) run(now, 3 * parent.size() + t, 0.0);
    while (at(inner, to) >= 0) {
      const bool again = history[to] != 0.0 && now.past[to] >= 0.0;
      to = again ? static_cast<Index>(now.past[to]) : at(inner, to);
    }
    now.leaf = to;
    for (Index l = common < 0 ? 0 : depth(common) + 1; l <= depth(to); ++l) {
      now.after[l] = 0.0;
      now.entered[l] = true;
      if (sets) run(now, 3 * holder(to, l) + enter, 0.0);
    }
  }

  /// Runs the settings of one event in order.
  void run(Now& now, Index occasion, double after) {
    const Index time_place = place_of_time();
    now.v[time_place] = after;
    for (Index a = at(first_setting, occasion); a < at(first_setting, occasion + 1); ++a) {
      now.v[time_place + 1] = static_cast<double>(a);
      now.v[u.count() + at(set_counter, a)] = setting(now.v);
    }
  }

 public:
  Period period{};
  Time time{};
};

using StateMachine = StateMachineOf<Function>;

}  // namespace stepwire
