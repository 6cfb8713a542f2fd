#pragma once

#include <limits>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// 1-D resistance map with the authorized region lower <= x <= upper.
struct Interval {
  PerElement lower = -std::numeric_limits<double>::infinity();
  PerElement upper = std::numeric_limits<double>::infinity();
  Input<> x{};
  Output<> depth{}, error{};

  void outputs() {
    for (Index i = 0; i < x.size(); ++i) {
      const double beyond = beyond_bound(x[i], lower[i], upper[i]);
      error[i] = beyond;
      depth[i] = beyond < 0.0 ? -beyond : beyond;
    }
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < x.size(); ++i) {
      zero.add(x[i] - lower[i]);
      zero.add(x[i] - upper[i]);
    }
  }

  void configure(Configure& is);

  static void declare(Declare<Interval>& is);

 private:
  static double beyond_bound(double x, double lower, double upper) {
    if (x > upper) return x - upper;
    return x < lower ? x - lower : 0.0;
  }
};

}  // namespace stepwire
