#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/block/block.hpp"

namespace stepwire {

/// A motion along a straight line that starts smoothly and goes on at constant speed: with t from `start` on,
/// v(t) = speed (1 - cos(pi t / rise)) / 2 up to t = rise, and speed from there.
struct StraightMotion {
  Numbers from{0.0}, direction{1.0};
  double speed = 0.01, rise = 0.0, start_ = 0.0;
  Output<> position{}, velocity{}, acceleration{};
  Output<1> distance{};
  Time time{};
  Numbers unit{};  ///< unit vector of the direction

  void prepare();
  void outputs() {
    const double t = std::max(time - start_, 0.0);
    distance = speed * (t < rise ? rising(t) : t - 0.5 * rise);
    const double v = time < start_ ? 0.0 : t < rise ? 0.5 * speed * (1.0 - std::cos(angle(t))) : speed;
    const double a = t < rise ? 0.5 * speed * std::numbers::pi / rise * std::sin(angle(t)) : 0.0;
    position.each([&](Index i) { return from[i] + distance * unit[i]; });
    velocity.each([&](Index i) { return v * unit[i]; });
    acceleration.each([&](Index i) { return a * unit[i]; });
  }

  void configure(Configure& is);
  static void declare(Declare<StraightMotion>& is);

 private:
  double angle(double t) const { return std::numbers::pi * t / rise; }
  /// Distance at unit speed while the speed rises.
  double rising(double t) const { return 0.5 * (t - rise / std::numbers::pi * std::sin(angle(t))); }
};

}  // namespace stepwire
