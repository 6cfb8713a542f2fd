#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Remembers: 1 from `set` until `reset`. True is above 0.
struct Latch {
  enum class Priority { reset, set };

  Priority priority = Priority::reset;
  Input<> set{}, reset{};
  Output<> y{};
  DiscreteState<> last{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = holds(i) ? 1.0 : 0.0;
  }

  void update() {
    for (Eigen::Index i = 0; i < last.size(); ++i) last.coeffRef(i) = holds(i) ? 1.0 : 0.0;
  }

  static void declare(Declare<Latch>& is);

 private:
  bool holds(Eigen::Index i) const {
    const bool sets = set.coeff(i) > 0.0, resets = reset.coeff(i) > 0.0;
    if (sets && resets) return priority == Priority::set;
    return sets || (!resets && last.coeff(i) > 0.0);
  }
};

}  // namespace stepwire
