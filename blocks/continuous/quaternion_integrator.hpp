#pragma once

#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Attitude from an angular velocity: dq/dt = q w / 2 with w in the rotating frame, or w q / 2 in the fixed
/// one.
struct QuaternionIntegrator : Resettable {
  enum class Frame { turned, fixed };

  Frame frame = Frame::turned;
  Input<3> rate{};
  Output<4> y{};
  State<4> x{};

  void outputs() { held() ? show(Targets{*this}) : show(x); }
  void outputs_at_instant() { resetting() ? show(Targets{*this}) : show(x); }

  void derivatives() {
    if (held()) {
      x.derivative = 0.0;
      return;
    }
    const double s = frame == Frame::turned ? 1.0 : -1.0;
    x.derivative[0] = -0.5 * (x[1] * rate[0] + x[2] * rate[1] + x[3] * rate[2]);
    x.derivative[1] = 0.5 * (x[0] * rate[0] + s * (x[2] * rate[2] - x[3] * rate[1]));
    x.derivative[2] = 0.5 * (x[0] * rate[1] + s * (x[3] * rate[0] - x[1] * rate[2]));
    x.derivative[3] = 0.5 * (x[0] * rate[2] + s * (x[1] * rate[1] - x[2] * rate[0]));
  }

  void update_before_instant() { follow_target(x); }
  /// Normalises the quaternion at each tick, since errors of the solver change its length.
  void update() {
    x = y;
    remember_reset();
  }

  void configure(Configure& is);
  void start() {
    if (x[0] == 0.0 && x[1] == 0.0 && x[2] == 0.0 && x[3] == 0.0) x[0] = 1.0;
    home = x;
  }
  static void declare(Declare<QuaternionIntegrator>& is);

 private:
  template <class States>
  void show(const States& states) {
    SumOfSquares squares;
    for (Index i = 0; i < 4; ++i) {
      y[i] = states[i];
      squares.add(y[i]);
    }
    const double length = squares.root();
    for (Index i = 0; i < 4; ++i) y[i] /= length;
  }
};

}  // namespace stepwire
