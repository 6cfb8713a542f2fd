#pragma once

#include "engine/base/math/instant.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// A jump from one value to another: y = before for t < time, else y = after.
struct Step {
  PerElement time = 1.0, before = 0.0, after = 1.0;
  Output<> y{};
  Time t{};

  void outputs() {
    y.each([&](Index k) { return reached(t, time[k]) ? after[k] : before[k]; });
  }

  double next_edge() const {
    double next = first_ahead(t, time[0]);
    for (Index k = 1; k < y.size(); ++k) next = std::min(next, first_ahead(t, time[k]));
    return next;
  }

  static void declare(Declare<Step>& is);
};

}  // namespace stepwire
