#pragma once

#include <algorithm>
#include <cmath>

#include "blocks/haptics/region/plane.hpp"
#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Positions and distances of the end-effector at two successive ticks, for the check of an event.
struct LayerMoment {
  Vector2 before, now;
  double distance_before, distance_now;  ///< from the region of the event, positive outside
  double since;  ///< time since the activation of the layer or the last event of its sequence
};

/// Event of a LayerActivator, as `size` numbers in memory: its kind and its parameters.
struct LayerEvent {
  enum Kind { passes, crosses, enters, leaves, elapses };
  static constexpr Index size = 6;

  const double* numbers;

  bool concerns_region() const { return kind() == enters || kind() == leaves; }
  Index region() const { return static_cast<Index>(numbers[1]); }

  bool happens(const LayerMoment& is) const {
    const Vector2 a{numbers[1], numbers[2]}, b{numbers[3], numbers[4]};
    switch (kind()) {
      case passes:
        return distance_of_way(a, is) <= numbers[3];
      case crosses:
        return crosses_line(a, b, is);
      case enters:
        return is.distance_before > 0.0 && is.distance_now <= 0.0;
      case leaves:
        return is.distance_before <= 0.0 && is.distance_now > 0.0;
      default:
        return is.since >= numbers[1];
    }
  }

 private:
  Kind kind() const { return static_cast<Kind>(static_cast<int>(numbers[0])); }

  /// Returns the distance between a point and the path between both ticks.
  static double distance_of_way(Vector2 point, const LayerMoment& is) {
    const Vector2 way = is.now - is.before;
    const double square = dot(way, way);
    const double share = square > 0.0 ? std::clamp(dot(point - is.before, way) / square, 0.0, 1.0) : 0.0;
    return length(point - (is.before + share * way));
  }

  /// True if the path crosses the line from a to b between its ends. It must lead from right to left, or with
  /// numbers[5] = -1 from left to right.
  bool crosses_line(Vector2 a, Vector2 b, const LayerMoment& is) const {
    const Vector2 line = b - a;
    const double was = numbers[5] * cross(line, is.before - a), now = numbers[5] * cross(line, is.now - a);
    if (!(was < 0.0 && now >= 0.0)) return false;
    const Vector2 hit = is.before + (was / (was - now)) * (is.now - is.before);
    const double along = dot(hit - a, line);
    return along >= 0.0 && along <= dot(line, line);
  }
};

}  // namespace stepwire
