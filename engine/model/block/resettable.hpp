#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Reset input of a block with states, such as Integrator. Blocks derive from it or from Resettable and
/// declare the members by declare_reset() (see declare_reset.hpp). Without a connected reset, `resets` is
/// false and is the only member to check.
struct ResetInput {
  enum class Trigger { rising, falling, either, level };

  Input<1> reset{};
  DiscreteState<1> side{};  // truth of the reset signal at the last tick: -1 false, 1 true, 0 not yet known
  Trigger trigger = Trigger::rising;
  bool resets = false;

  /// True at a tick at which the block resets; constant until remember_reset().
  bool resetting() const { return resets && reset.connected() && fires(trigger, side, reset > 0.0); }
  /// True where a level trigger holds the states between instants. It is a mode: it is evaluated at an
  /// instant and applies up to the next one.
  bool held() const { return resets && trigger == Trigger::level && reset.connected() && side > 0.0; }
  /// Adds the crossing that declare_reset() declares; a block with crossings of its own calls it first.
  void crossings(Crossings& zero) const { zero.add_connected(reset); }
  /// Stores the truth of the reset signal; called last in update().
  void remember_reset() {
    if (resets) side = reset.connected() && reset > 0.0 ? 1.0 : -1.0;
  }

  /// True where a change from `before` (-1 false, 1 true, 0 unknown) to `high` triggers a reset.
  static bool fires(Trigger trigger, double before, bool high) {
    if (trigger == Trigger::level) return high;
    const bool rose = before < 0.0 && high, fell = before > 0.0 && !high;
    return (rose && trigger != Trigger::falling) || (fell && trigger != Trigger::rising);
  }
};

/// ResetInput with a target: `value` if connected, else the input `initial` if connected, else the initial
/// value. A connected `initial` also sets the state at the first tick.
struct Resettable : ResetInput {
  Input<> value{}, initial_{};
  DiscreteState<> home{};  // initial value of the state

  bool starting() const { return side == 0.0 && initial_.connected(); }
  bool resetting() const { return resets && (starting() || ResetInput::resetting()); }
  double target(Index i) const {
    if (value.connected() && !starting()) return value[i];
    return initial_.connected() ? initial_[i] : home[i];
  }
  /// Sets held states to their targets just before an instant: while a level trigger holds them they follow
  /// their targets, and a release begins there.
  template <class States>
  void follow_target(States& states) const {
    for (Index i = 0; held() && i < states.size(); ++i) states[i] = target(i);
  }
};

/// Targets of all states, indexed like the states.
struct Targets {
  const Resettable& of;
  double operator[](Index i) const { return of.target(i); }
};

}  // namespace stepwire
