#pragma once

#include "engine/base/expression/language.hpp"  // for guards that are code
#include "engine/base/math/function.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/tree.hpp"

namespace stepwire {

/// A finite state machine: states with output values, and transitions where their guards hold.
struct StateMachine {
  static constexpr Index max_inputs = 64;

  Tree states;
  Text initial;
  Inputs u{};
  Output<1> state{};
  Output<> y{};
  DiscreteState<1> active{}, ticks{};  // index of the state; ticks since it was entered
  Period period{};

  Function successor{};  ///< the state after a tick, of u1, u2, ..., the time in the state, and the state
  Numbers values{};      ///< y of the first state, of the second, ...
  Index first = 0;

  void outputs() {
    const double now = next();
    state = now;
    const double* const here = values.data() + static_cast<Index>(now) * y.size();
    y.each([&](Index i) { return here[i]; });
  }

  void update() {
    const double now = next();
    ticks = now == active ? ticks + 1.0 : 1.0;
    active = now;
  }

  void start() { active = static_cast<double>(first); }
  void configure(Configure& is);
  static void declare(Declare<StateMachine>& is);

 private:
  /// The state after this tick's transition, if there is one.
  double next() {
    double known[max_inputs + 2];
    for (Index i = 0; i < u.count(); ++i) known[i] = u.first(i);
    known[u.count()] = ticks * period;
    known[u.count() + 1] = active;
    return successor(known);
  }
};

}  // namespace stepwire
