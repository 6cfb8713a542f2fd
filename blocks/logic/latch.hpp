#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Flip-flop: 1 from `set` until `reset`. True is above 0.
struct Latch {
  enum class Priority { reset, set };

  Priority priority = Priority::reset;
  Input<> set{}, reset{};
  Output<> y{};
  DiscreteState<> last{};

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) y[i] = holds(i) ? 1.0 : 0.0;
  }

  void update() {
    for (Index i = 0; i < last.size(); ++i) last[i] = holds(i) ? 1.0 : 0.0;
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < set.size(); ++i) zero.add(set[i]);
    for (Index i = 0; i < reset.size(); ++i) zero.add(reset[i]);
  }

  static void declare(Declare<Latch>& is);

 private:
  bool holds(Index i) const {
    const bool sets = set[i] > 0.0, resets = reset[i] > 0.0;
    if (sets && resets) return priority == Priority::set;
    return sets || (!resets && last[i] > 0.0);
  }
};

}  // namespace stepwire
