#pragma once

#include <algorithm>

#include "blocks/sources/own_time.hpp"
#include "engine/base/math/instant.hpp"

namespace stepwire {

/// Linear ramp from one instant on: y = initial + slope max(0, t - start).
struct Ramp : OwnTime {
  PerElement slope = 1.0, start_ = 0.0, initial = 0.0;
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return initial[i] + slope[i] * std::max(t - corner(i), 0.0); });
  }

  double next_edge() const {
    double next = first_ahead(t, corner(0));
    for (Index i = 1; i < y.size(); ++i) next = std::min(next, first_ahead(t, corner(i)));
    return next;
  }

  void update() { keep_origin(); }
  void configure(Configure& is);
  static void declare(Declare<Ramp>& is);

 private:
  /// Returns the begin of the ramp as an instant of the run.
  double corner(Index i) const { return began() + start_[i]; }
};

}  // namespace stepwire
