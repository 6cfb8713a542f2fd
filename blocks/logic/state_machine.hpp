#pragma once

#include <string>
#include <vector>

#include "engine/block/block.hpp"
#include "engine/block/value.hpp"
#include "engine/expression/expression.hpp"

namespace stepwire {

/// A finite state machine: states with output values, and transitions where their guards hold.
struct StateMachine {
  /// A formula, and which of the known numbers (u1, u2, ..., time in the state) each of its variables is.
  struct Guard {
    Expression formula;
    std::vector<std::size_t> reads;
    std::vector<double> values;

    bool holds(const std::vector<double>& known) {
      for (std::size_t i = 0; i < reads.size(); ++i) values[i] = known[reads[i]];
      return formula(values) != 0.0;
    }
  };
  struct Transition {
    std::size_t target;
    Guard guard;
  };
  struct Stage {
    std::string name;
    std::vector<double> output;
    std::vector<Transition> to;
  };

  Value states{Value::Map{}};
  Text initial;
  Inputs u{};
  Output<1> state{};
  Output<> y{};
  DiscreteState<1> active{}, ticks{};  // index of the state; ticks since it was entered
  Period period{};

  std::vector<Stage> stages;
  std::size_t first = 0;
  std::vector<double> known;

  void outputs() {
    const std::size_t now = next();
    state = static_cast<double>(now);
    const std::vector<double>& values = stages[now].output;
    for (Index i = 0; i < y.size(); ++i) y[i] = values[static_cast<std::size_t>(i)];
  }

  void update() {
    const double now = static_cast<double>(next());
    ticks = now == active ? ticks + 1.0 : 1.0;
    active = now;
  }

  void start() { active = static_cast<double>(first); }
  void configure(Configure& is);
  static void declare(Declare<StateMachine>& is);

 private:
  /// The state after this tick's transition, if there is one.
  std::size_t next() {
    const std::size_t now = static_cast<std::size_t>(active);
    for (Index i = 0; i < u.count(); ++i) known[static_cast<std::size_t>(i)] = u[i][0];
    known.back() = ticks * period;
    for (Transition& transition : stages[now].to)
      if (transition.guard.holds(known)) return transition.target;
    return now;
  }
};

}  // namespace stepwire
