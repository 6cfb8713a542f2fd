#pragma once

#include <cmath>

#include "blocks/sources/instant.hpp"
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

  /// Edges are compared as instants of the run, since that is where their rounding is known.
  bool high(Index k) const {
    const double first = delay[k], length = period[k];
    if (!reached(t, first)) return false;
    double begin = first + length * std::floor((t - first) / length);
    if (reached(t, begin + length)) begin += length;
    return !reached(t, begin + width[k] * length);
  }

  static void declare(Declare<Pulse>& is);
};

}  // namespace stepwire
