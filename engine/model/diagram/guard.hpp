#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire::diagram {

/// Internal block that determines at every tick whether its blocks are active: those of a part, or a single
/// one. They are active while `enable` is above 0; with a `trigger`, only at the ticks at which that crosses
/// 0 meanwhile.
struct Guard {
  enum class Edge { rising, falling, either };
  enum class States { held, reset };

  Edge edge = Edge::rising;
  States states = States::held;
  Input<1> enable{}, trigger{};
  Output<1> active{};
  DiscreteState<1> seen{}, high{};  ///< 1 after the first tick; truth of the trigger at the last tick

  void outputs() {
    const bool enabled = !enable.connected() || enable > 0.0;
    active = enabled && (!trigger.connected() || crosses()) ? 1.0 : 0.0;
  }

  void update() {
    seen = 1.0;
    high = trigger.connected() && trigger > 0.0 ? 1.0 : 0.0;
  }

  void crossings(Crossings& zero) const {
    zero.add(enable.connected() ? enable : 0.0);
    zero.add(trigger.connected() ? trigger : 0.0);
  }

  static void declare(Declare<Guard>& is);

 private:
  bool crosses() const {
    const bool is_high = trigger > 0.0, was_high = high > 0.0;
    if (seen == 0.0 || is_high == was_high) return false;
    return edge == Edge::either || is_high == (edge == Edge::rising);
  }
};

/// Output of a part or block with `outputs: reset`, as other blocks read it. It passes the output through
/// while active, and has the value `off` otherwise.
struct GuardedOutput {
  PerElement off = 0.0;
  Input<> u{};
  Input<1> active{};
  Output<> y{};

  void outputs() {
    const bool is_active = active != 0.0;
    y.each([&](Index k) { return is_active ? u[k] : off[k]; });
  }

  static void declare(Declare<GuardedOutput>& is);
};

/// Block that makes a parameter recordable as a signal.
struct ParameterValue {
  PerElement value = 0.0;
  Output<> y{};

  void outputs() { y = value; }

  static void declare(Declare<ParameterValue>& is);
};

}  // namespace stepwire::diagram
