#pragma once

#include <algorithm>
#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// How one means to go on along a circle: velocity = pace v t + k (R - r) e, where e points outward from the
/// centre to where one believes to be, r is how far that is, and t is e turned to the left.
struct CirclePlan {
  Input<2> position{}, center{};
  Input<1> pace{};
  double radius = 1.0, speed = 0.0, correction = 0.0;
  Output<2> velocity{}, outward{};
  Output<1> turned{};
  DiscreteState<2> facing{};  ///< e at the last tick; 0 before the first
  DiscreteState<1> angle{};   ///< turned until then

  void outputs() {
    const double x = position[0] - center[0], y = position[1] - center[1], r = std::hypot(x, y);
    outward[0] = r > 0.0 ? x / r : 1.0;
    outward[1] = r > 0.0 ? y / r : 0.0;
    const double on = speed * (pace.connected() ? std::max(0.0, static_cast<double>(pace)) : 1.0);
    const double out = correction * (radius - r);
    velocity[0] = out * outward[0] - on * outward[1];
    velocity[1] = out * outward[1] + on * outward[0];
    turned = angle + turn();
  }

  void update() {
    angle = turned;
    facing = outward;
  }

  static void declare(Declare<CirclePlan>& is);

 private:
  /// From the last tick to this one, within half a turn.
  double turn() const {
    return std::atan2(facing[0] * outward[1] - facing[1] * outward[0],
                      facing[0] * outward[0] + facing[1] * outward[1]);
  }
};

}  // namespace stepwire
