#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Minimum or maximum of several signals, element by element.
struct MinMax {
  enum class Function { min, max };

  Function function = Function::min;
  Inputs u{};
  Output<> y{};

  void outputs() {
    const Index inputs = u.count();
    STEPWIRE_UNROLLED
    for (Index k = 0; k < y.size(); ++k) {
      double best = u[0][k];
      STEPWIRE_UNROLLED
      for (Index i = 1; i < inputs; ++i) best = better(u[i][k], best);
      y[k] = best;
    }
  }

  /// Adds, for each input but the first, its distance to the best of those before it.
  void crossings(Crossings& zero) const {
    for (Index i = 1; i < u.count(); ++i)
      for (Index k = 0; k < y.size(); ++k) {
        double best = u[0][k];
        for (Index j = 1; j < i; ++j) best = better(u[j][k], best);
        zero.add(u[i][k] - best);
      }
  }

  void configure(Configure& is);

  double better(double a, double b) const {
    return function == Function::min ? (a < b ? a : b) : (a > b ? a : b);
  }

  static void declare(Declare<MinMax>& is);
};

}  // namespace stepwire
