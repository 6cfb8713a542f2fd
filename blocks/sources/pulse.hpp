#pragma once

#include <cmath>
#include <numbers>

#include "blocks/sources/own_time.hpp"
#include "engine/base/math/instant.hpp"

namespace stepwire {

/// Rectangular pulse train: y = bias + amplitude in the first `width` of each period, else y = bias. It
/// starts at `delay`, with `phase` after a rising edge.
struct Pulse : OwnTime {
  PerElement amplitude = 1.0, period = 1.0, width = 0.5, delay = 0.0, phase = 0.0, bias = 0.0;
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return bias[k] + (high(k) ? amplitude[k] : 0.0); });
  }

  double next_edge() const {
    double next = edge_of(0);
    for (Index k = 1; k < y.size(); ++k) next = std::min(next, edge_of(k));
    return next;
  }

  bool high(Index k) const {
    return reached(t, begin(k)) && !reached(t, begin_of_period(k) + width[k] * period[k]);
  }

  void update() { keep_origin(); }
  void configure(Configure& is);
  static void declare(Declare<Pulse>& is);

 private:
  /// Returns the begin of the train. Edges are compared as instants of the run, whose rounding is known.
  double begin(Index k) const { return began() + delay[k]; }
  /// Returns the begin of the present period.
  double begin_of_period(Index k) const {
    const double first = begin(k) - phase[k] / (2.0 * std::numbers::pi) * period[k];
    const double begin = first + period[k] * std::floor((t - first) / period[k]);
    return reached(t, begin + period[k]) ? begin + period[k] : begin;
  }
  double edge_of(Index k) const {
    if (!reached(t, begin(k))) return begin(k);
    const double begin = begin_of_period(k);
    return first_ahead(t, begin + width[k] * period[k], begin + period[k]);
  }
};

}  // namespace stepwire
