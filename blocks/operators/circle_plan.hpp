#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Next via point along a circle of radius R, from the position of the hand at the end of the present
/// movements, (r, theta) about the centre:
///
///     r' = r + (R - r) (1 - exp(-correction interval)),   theta' = theta + speed interval / R.
struct CirclePlan {
  Input<2> position{}, pending{}, center{};
  Input<1> speed{}, interval{};
  double radius = 1.0, correction = 0.0;
  Output<2> step{}, righting{}, outward{};
  Output<1> turned{}, off{};
  DiscreteState<2> facing{};  ///< outward at the last tick; 0 before the first one
  DiscreteState<1> angle{};   ///< turned until the last tick

  void outputs() {
    const double x = position[0] - center[0], y = position[1] - center[1], r = fn::hypot(x, y);
    outward[0] = r > 0.0 ? x / r : 1.0;
    outward[1] = r > 0.0 ? y / r : 0.0;
    off = r - radius;
    turned = angle + turn();
    plan(x + pending[0], y + pending[1]);
  }

  void update() {
    angle = turned;
    facing = outward;
  }

  static void declare(Declare<CirclePlan>& is);

 private:
  /// Returns the angle from the last tick to this one, within half a turn.
  double turn() const {
    return fn::atan2(facing[0] * outward[1] - facing[1] * outward[0],
                     facing[0] * outward[0] + facing[1] * outward[1]);
  }

  /// Computes the step from (x, y), about the centre, to the via point.
  void plan(double x, double y) {
    const double r = fn::hypot(x, y), theta = fn::atan2(y, x) + speed * interval / radius;
    const double next = r - (radius - r) * fn::expm1(-correction * interval);
    step[0] = next * fn::cos(theta) - x;
    step[1] = next * fn::sin(theta) - y;
    righting[0] = (next - r) * fn::cos(theta);
    righting[1] = (next - r) * fn::sin(theta);
  }
};

}  // namespace stepwire
