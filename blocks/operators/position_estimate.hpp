#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Kalman filter for a position x whose motion m is predicted, with the same variance P along each axis:
///
///     x <- x + change of m,  P <- P + (doubt |change of m|)^2,
///     for each measurement z of precision p:  P <- P/(1 + p P),  x <- x + p P (z - x).
struct PositionEstimate {
  double doubt = 0.5;
  Input<2> model{};
  Inputs measured{}, precision{};
  Output<2> y{};
  Output<1> variance{};
  DiscreteState<2> before{}, last{};
  DiscreteState<1> spread{}, begun{};

  void outputs() {
    predict();
    for (Index channel = 0; channel < measured.count(); ++channel)
      if (precision.first(channel) > 0.0) fuse(measured[channel], precision.first(channel));
  }

  void update() {
    before = y;
    spread = variance;
    last = model;
    begun = 1.0;
  }

  void configure(Configure& is);
  static void declare(Declare<PositionEstimate>& is);

 private:
  void predict() {
    constexpr double nothing_known = 1e6;  // [m^2]: only the first measurement has weight
    const bool first = begun == 0.0;
    const double x = first ? 0.0 : model[0] - last[0], y_moved = first ? 0.0 : model[1] - last[1];
    y[0] = first ? model[0] : before[0] + x;
    y[1] = first ? model[1] : before[1] + y_moved;
    variance = first ? nothing_known : spread + doubt * doubt * (x * x + y_moved * y_moved);
  }

  void fuse(const Inputs::Element& value, double precise) {
    variance = variance / (1.0 + precise * variance);
    for (Index i = 0; i < 2; ++i) y[i] = y[i] + precise * variance * (value[i] - y[i]);
  }
};

}  // namespace stepwire
