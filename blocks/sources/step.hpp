#pragma once

#include "blocks/sources/own_time.hpp"
#include "engine/base/math/instant.hpp"

namespace stepwire {

/// Step from one value to another: y = before for t < time, else y = after.
struct Step : OwnTime {
  PerElement time = 1.0, before = 0.0, after = 1.0;
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return reached(t, jump(k)) ? after[k] : before[k]; });
  }

  double next_edge() const {
    double next = first_ahead(t, jump(0));
    for (Index k = 1; k < y.size(); ++k) next = std::min(next, first_ahead(t, jump(k)));
    return next;
  }

  void update() { keep_origin(); }
  void configure(Configure& is);
  static void declare(Declare<Step>& is);

 private:
  /// Returns the step time as an instant of the run.
  double jump(Index k) const { return began() + time[k]; }
};

}  // namespace stepwire
