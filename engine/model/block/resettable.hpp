#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The reset input of a block with states, as Integrator has it. Derive from it, or from Resettable, and name
/// the members by declare_reset() (see declare_reset.hpp). Where nothing is wired `resets` is false, and a
/// block asks for nothing else.
struct ResetInput {
  enum class Trigger { rising, falling, either, level };

  Input<1> reset{};
  DiscreteState<1> side{};  // of the reset signal at the last tick: -1 false, 1 true, 0 none seen yet
  Trigger trigger = Trigger::rising;
  bool resets = false;

  /// Is this tick one of a reset? The same answer until remember_reset().
  bool resetting() const { return resets && reset.connected() && fires(trigger, side, reset > 0.0); }
  /// Does a level hold the states between ticks? As it was at the last tick, for the whole step: a signal that
  /// falls within one would spoil the solver's order.
  bool held() const { return resets && trigger == Trigger::level && reset.connected() && side > 0.0; }
  /// Of what declare_reset() declares; a block that has crossings of its own calls it first.
  void crossings(Crossings& zero) const { zero.add(reset.connected() ? reset : 0.0); }
  /// The last thing in update().
  void remember_reset() {
    if (resets) side = reset.connected() && reset > 0.0 ? 1.0 : -1.0;
  }

  /// Does a signal that was `before` (-1 false, 1 true, 0 none yet) and is now `high` trigger?
  static bool fires(Trigger trigger, double before, bool high) {
    if (trigger == Trigger::level) return high;
    const bool rose = before < 0.0 && high, fell = before > 0.0 && !high;
    return (rose && trigger != Trigger::falling) || (fell && trigger != Trigger::rising);
  }
};

/// As well, what the state goes back to: `value` where it is wired, else the wire `initial`, else the initial
/// value. A wire `initial` gives the state at the first tick, too.
struct Resettable : ResetInput {
  Input<> value{}, initial_{};
  DiscreteState<> home{};  // the initial value

  bool starting() const { return side == 0.0 && initial_.connected(); }
  bool resetting() const { return resets && (starting() || ResetInput::resetting()); }
  double target(Index i) const {
    if (value.connected() && !starting()) return value[i];
    return initial_.connected() ? initial_[i] : home[i];
  }
};

/// What all states go back to, read as the states are.
struct Targets {
  const Resettable& of;
  double operator[](Index i) const { return of.target(i); }
};

}  // namespace stepwire
