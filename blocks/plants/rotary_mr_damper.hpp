#pragma once

#include "blocks/plants/mr_damper_core.hpp"

namespace stepwire {

/// Rotary magnetorheological damper (a brake): T = k0 x + unit (c(i) v + alpha(i) z) + f0 over the angle x.
struct RotaryMRDamper : MRDamperCore {
  enum class TorqueUnit { lbf_in, N_m, N_cm, lbf_ft };

  TorqueUnit torque_unit = TorqueUnit::lbf_in;
  double presliding_scale = 1.0;
  double assumed_below = 0.0;
  Output<1> torque{};
  Notice assumed{};

  RotaryMRDamper();
  void prepare() { scale(newton_metres(torque_unit), presliding_scale); }
  void outputs() {
    write_account();
    torque = resistance();
  }
  void derivatives() { write_rates(); }
  void update() {
    remember();
    if (current < assumed_below && within_range(current)) assumed.raise(time);
  }

  static constexpr double newton_metres(TorqueUnit unit) {
    constexpr double pound_force = 4.4482216152605, inch = 0.0254;
    switch (unit) {
      case TorqueUnit::lbf_in:
        return pound_force * inch;
      case TorqueUnit::lbf_ft:
        return pound_force * 12.0 * inch;
      case TorqueUnit::N_cm:
        return 0.01;
      default:
        return 1.0;
    }
  }

  static void declare(Declare<RotaryMRDamper>& is);
};

}  // namespace stepwire
