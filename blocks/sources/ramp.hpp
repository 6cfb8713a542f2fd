#pragma once

#include <algorithm>

#include "engine/base/math/instant.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// A value that grows steadily from one instant on: y = initial + slope max(0, t - start).
struct Ramp {
  PerElement slope = 1.0, start_ = 0.0, initial = 0.0;
  Output<> y{};
  Time t{};

  void outputs() {
    y.each([&](Index i) { return initial[i] + slope[i] * std::max(t - start_[i], 0.0); });
  }

  double next_edge() const {
    double next = first_ahead(t, start_[0]);
    for (Index i = 1; i < y.size(); ++i) next = std::min(next, first_ahead(t, start_[i]));
    return next;
  }

  static void declare(Declare<Ramp>& is);
};

}  // namespace stepwire
