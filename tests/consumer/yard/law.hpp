#pragma once

namespace yard {

/// Force of a flow that resists with the square of the speed.
inline double drag_force(double coefficient, double speed) {
  return -coefficient * speed * (speed < 0.0 ? -speed : speed);
}

}  // namespace yard
