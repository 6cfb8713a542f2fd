#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blocks/sources/own_time.hpp"
#include "engine/base/math/elementary.hpp"
#include "engine/base/math/instant.hpp"
#include "engine/base/math/sum_of_squares.hpp"

namespace stepwire {

/// Motion along a straight line with a smooth start and then constant speed. With t from `start` on, v(t) =
/// speed (1 - cos(pi t / rise)) / 2 up to t = rise, and then `speed`. In the plane `turn` is added to the
/// angle of its direction.
struct StraightMotion : OwnTime {
  Numbers from{0.0}, direction{1.0};
  double speed = 0.01, rise = 0.0, start_ = 0.0;
  Input<1> turn{};
  Output<> position{}, velocity{}, acceleration{};
  Output<1> distance{};
  Numbers unit{};  ///< unit vector of the direction

  void prepare() {
    unit = direction.map([length = length()](double element) { return element / length; });
  }
  void outputs() {
    const double begin = began() + start_, since = std::max(t - begin, 0.0);
    distance = speed * (since < rise ? rising(since) : since - 0.5 * rise);
    const double v = t < begin ? 0.0 : since < rise ? 0.5 * speed * (1.0 - fn::cos(angle(since))) : speed;
    const double a = since < rise ? 0.5 * speed * std::numbers::pi / rise * fn::sin(angle(since)) : 0.0;
    const Turn by = turn.connected() ? Turn{fn::cos(turn), fn::sin(turn)} : Turn{};
    position.each([&](Index i) { return from[i] + distance * turned(i, by); });
    velocity.each([&](Index i) { return v * turned(i, by); });
    acceleration.each([&](Index i) { return a * turned(i, by); });
  }

  double next_edge() const { return first_ahead(t, began() + start_, began() + start_ + rise); }

  void update() { keep_origin(); }
  void configure(Configure& is);
  static void declare(Declare<StraightMotion>& is);

 private:
  /// Returns the length of the direction vector.
  double length() const {
    return length_of(direction.size(), [&](Index i) { return direction[i]; });
  }

  struct Turn {
    double cos = 1.0, sin = 0.0;
  };

  /// Returns an element of the unit vector, rotated in the plane.
  double turned(Index i, const Turn& by) const {
    if (!turn.connected()) return unit[i];
    return i == 0 ? by.cos * unit[0] - by.sin * unit[1] : by.sin * unit[0] + by.cos * unit[1];
  }

  double angle(double since) const { return std::numbers::pi * since / rise; }
  /// Returns the distance at unit speed during the rise.
  double rising(double since) const {
    return 0.5 * (since - rise / std::numbers::pi * fn::sin(angle(since)));
  }
};

}  // namespace stepwire
