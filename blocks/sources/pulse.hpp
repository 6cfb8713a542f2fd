#pragma once

#include <cmath>

#include "engine/base/math/instant.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// A train of rectangles: y = bias + amplitude in the first `width` of each period, else y = bias; from
/// `delay` on.
struct Pulse {
  PerElement amplitude = 1.0, period = 1.0, width = 0.5, delay = 0.0, bias = 0.0;
  Output<> y{};
  Time t{};

  void outputs() {
    y.each([&](Index k) { return bias[k] + (high(k) ? amplitude[k] : 0.0); });
  }

  double next_edge() const {
    double next = edge_of(0);
    for (Index k = 1; k < y.size(); ++k) next = std::min(next, edge_of(k));
    return next;
  }

  bool high(Index k) const { return reached(t, delay[k]) && !reached(t, begin(k) + width[k] * period[k]); }

  static void declare(Declare<Pulse>& is);

 private:
  /// Of the present period. Edges are compared as instants of the run, since that is where their rounding is
  /// known.
  double begin(Index k) const {
    const double begin = delay[k] + period[k] * std::floor((t - delay[k]) / period[k]);
    return reached(t, begin + period[k]) ? begin + period[k] : begin;
  }
  double edge_of(Index k) const {
    if (!reached(t, delay[k])) return delay[k];
    return first_ahead(t, begin(k) + width[k] * period[k], begin(k) + period[k]);
  }
};

}  // namespace stepwire
