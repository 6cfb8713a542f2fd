#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Mean of directions that are judged repeatedly, each with an independent error (`noise`) and a constant one
/// (`bias`). With w <- (1 - forgetting) w + 1, the discounted count of looks,
///
///     y = direction of the sum,   1/precision = bias^2 + noise^2 q/w^2,   q <- (1 - forgetting)^2 q + 1.
struct DirectionAverage {
  double noise = 0.1, bias = 0.0, forgetting = 0.0;
  Input<1> direction{}, shown{};
  Output<1> y{}, precision{};
  DiscreteState<2> sum{};
  DiscreteState<1> weight{}, squares{};

  void outputs() {
    const double x = kept() * sum[0] + counts() * fn::cos(direction);
    const double across = kept() * sum[1] + counts() * fn::sin(direction);
    const double w = kept() * weight + counts(), q = kept() * kept() * squares + counts();
    y = fn::atan2(across, x);
    precision = w > 0.0 ? 1.0 / (bias * bias + noise * noise * q / (w * w)) : 0.0;
  }

  void update() {
    sum[0] = kept() * sum[0] + counts() * fn::cos(direction);
    sum[1] = kept() * sum[1] + counts() * fn::sin(direction);
    weight = kept() * weight + counts();
    squares = kept() * kept() * squares + counts();
  }

  static void declare(Declare<DirectionAverage>& is);

 private:
  double counts() const { return !shown.connected() || shown != 0.0 ? 1.0 : 0.0; }
  double kept() const { return counts() != 0.0 ? 1.0 - forgetting : 1.0; }
};

}  // namespace stepwire
