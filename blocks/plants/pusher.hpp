#pragma once

#include <algorithm>

#include "engine/base/math/instant.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Programmable motor that moves a pin straight from point to point, against any resistance. On each leg it
/// accelerates with `highest_acceleration`, cruises at `speed`, decelerates and stops.
struct Pusher {
  Matrix points;
  double speed = 0.01, highest_acceleration = 0.5, begin = 0.0;
  Output<> position{}, velocity{}, acceleration{};
  Output<1> distance{}, leg{};
  Time time{};
  Numbers legs{};  ///< `leg_size` numbers for each leg

  void prepare();
  void outputs() {
    const double t = std::max(time - begin, 0.0);
    const Index last = points.rows() - 2;
    Index k = 0;
    while (k < last && reached(time, begin + number(k + 1, starts))) ++k;
    const Instant now = instant(k, t - number(k, starts));
    distance = number(k, before) + now.way;
    leg = static_cast<double>(k + 1);
    const double length = number(k, way);
    position.each([&](Index i) { return points(k, i) + now.way / length * run(k, i); });
    velocity.each([&](Index i) { return now.speed / length * run(k, i); });
    acceleration.each([&](Index i) { return now.rise / length * run(k, i); });
  }

  double next_edge() const {
    for (Index k = 0; k + 1 < points.rows(); ++k)
      for (const double after : {0.0, number(k, rising), up_to_brake(k), up_to_brake(k) + number(k, rising)})
        if (const double edge = begin + number(k, starts) + after; !reached(time, edge)) return edge;
    return std::numeric_limits<double>::infinity();
  }

  void configure(Configure& is);
  static void declare(Declare<Pusher>& is);

  /// Numbers of a leg: its start time, the distance before it, its length, and the times of its acceleration
  /// and cruise phases.
  enum LegNumber { starts, before, way, rising, cruising, leg_size };

 private:
  /// Distance, speed and acceleration along a leg k.
  struct Instant {
    double way, speed, rise;
  };

  double number(Index k, LegNumber which) const { return legs[k * leg_size + which]; }
  double run(Index k, Index i) const { return points(k + 1, i) - points(k, i); }

  /// Returns the time from the start of a leg to its braking.
  double up_to_brake(Index k) const { return number(k, rising) + number(k, cruising); }

  Instant instant(Index k, double t) const {
    const double up = number(k, rising), top = highest_acceleration * up, start = begin + number(k, starts);
    if (!reached(time, begin)) return {0.0, 0.0, 0.0};
    if (!reached(time, start + up))
      return {0.5 * highest_acceleration * t * t, highest_acceleration * t, highest_acceleration};
    if (!reached(time, start + up_to_brake(k))) return {top * (t - 0.5 * up), top, 0.0};
    const double left = up_to_brake(k) + up - t;
    if (left <= 0.0 || reached(time, start + up_to_brake(k) + up)) return {number(k, way), 0.0, 0.0};
    return {number(k, way) - 0.5 * highest_acceleration * left * left, highest_acceleration * left,
            -highest_acceleration};
  }
};

}  // namespace stepwire
