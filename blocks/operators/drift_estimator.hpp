#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Kalman filter for a drifting vector x in the plane (an Ornstein-Uhlenbeck process over s). Each channel
/// measures it along one direction d, as z = d x + noise. With r = exp(-|change of s| / correlation), from
/// tick to tick
///
///     x <- r x,  P <- r^2 P + (1 - r^2) deviation^2 I,
///
/// and then for each channel, whose noise has the precision p (one over its variance),
///
///     x <- x + K (z - d x),  P <- P - K (P d)',  K = P d p / (1 + p d P d),
///
/// so precisions add up, and a channel of precision 0 is ignored.
struct DriftEstimator {
  double deviation = 1.0, correlation = 1.0;
  Inputs measured{}, precision{};
  Input<2> direction{};
  Input<1> along{};
  Output<2> estimate{};
  Output<3> covariance{};  ///< elements 11, 12 and 22 of P
  DiscreteState<2> before{};
  DiscreteState<3> spread{};  ///< covariance after the last tick
  DiscreteState<1> last{}, begun{};

  void outputs() {
    predict();
    for (Index channel = 0; channel < measured.count(); ++channel)
      if (precision.first(channel) > 0.0) fuse(measured.first(channel), precision.first(channel));
  }

  void update() {
    before = estimate;
    spread = covariance;
    last = along;
    begun = 1.0;
  }

  /// Sets the initial covariance to the stationary one of the drift.
  void start() { spread[0] = spread[2] = deviation * deviation; }

  void configure(Configure& is);
  static void declare(Declare<DriftEstimator>& is);

 private:
  void predict() {
    const double ago = begun != 0.0 ? std::abs(along - last) / correlation : 0.0;
    const double kept = fn::exp(-ago), fresh = -fn::expm1(-2.0 * ago) * deviation * deviation;
    estimate.each([&](Index i) { return kept * before[i]; });
    covariance.each([&](Index i) { return kept * kept * spread[i] + (i == 1 ? 0.0 : fresh); });
  }

  void fuse(double value, double precise) {
    const double x = direction[0], y = direction[1];
    const double toward_x = covariance[0] * x + covariance[1] * y;
    const double toward_y = covariance[1] * x + covariance[2] * y;
    const double share = precise / (1.0 + precise * (x * toward_x + y * toward_y));
    const double surprise = value - (x * estimate[0] + y * estimate[1]);
    estimate[0] = estimate[0] + share * toward_x * surprise;
    estimate[1] = estimate[1] + share * toward_y * surprise;
    covariance[0] = covariance[0] - share * toward_x * toward_x;
    covariance[1] = covariance[1] - share * toward_x * toward_y;
    covariance[2] = covariance[2] - share * toward_y * toward_y;
  }
};

}  // namespace stepwire
