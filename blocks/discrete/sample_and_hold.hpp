#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Samples its input when a trigger fires, and holds it in between.
struct SampleAndHold {
  using Trigger = ResetInput::Trigger;

  Trigger trigger = Trigger::rising;
  Input<> u{};
  Input<1> when{};
  Output<> y{};
  DiscreteState<> last{};
  DiscreteState<1> side{};  // of `when` at the last tick: -1 false, 1 true, 0 unknown

  void outputs() {
    const bool now = takes();
    for (Index i = 0; i < y.size(); ++i) y[i] = now ? u[i] : last[i];
  }

  /// Takes the last sample of a level trigger that may become false at the coming instant.
  void update_before_instant() {
    if (side > 0.0) last = u;
  }
  void update() {
    if (takes()) last = u;
    side = when > 0.0 ? 1.0 : -1.0;
  }

  void crossings(Crossings& zero) const { zero.add(when); }

  void configure(Configure& is);
  static void declare(Declare<SampleAndHold>& is);

 private:
  bool takes() const { return ResetInput::fires(trigger, side, when > 0.0); }
};

}  // namespace stepwire
