#pragma once

#include "blocks/plants/mr_damper_core.hpp"

namespace stepwire {

/// Rotary magnetorheological damper (a brake): T = k0 x + unit (c(i) v + alpha(i) z) + f0 over the angle x.
struct RotaryMRDamper : MRDamperCore {
  enum class TorqueUnit { lbf_in, N_m, N_cm, lbf_ft };

  TorqueUnit torque_unit = TorqueUnit::lbf_in;
  double presliding_scale = 1.0;
  double assumed_below = 0.0;
  double highest_current = 0.0, highest_speed = 0.0,
         rated_torque = 0.0;  ///< ratings, without effect on a run
  double lowest_temperature = 0.0, highest_temperature = 0.0;
  Output<1> torque{};
  Diagnostic assumed{};

  RotaryMRDamper();
  void prepare() { scale(newton_metres(torque_unit), presliding_scale); }
  void outputs() { torque = write_account(); }
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

/// Parameters of thesis eq. 8-10, with the angle in rad, time in s and current in A. The torque's unit is not
/// printed. It is assumed to be pound-force inch, because the limit of 17.7 at 0.75 A is then the 2 N m of
/// the transducer that was used.
inline void rd_2087_01(RotaryMRDamper& damper) {
  damper.k0 = 0.0;
  damper.A = 2.7789;
  damper.beta = 5.1269;
  damper.n = 1.0;
  damper.gamma = 1.5960;
  damper.c = {-0.208, 0.377, -0.215, 0.042};
  damper.alpha = {-25.99, 49.02, 28.05, 5.23};
  damper.torque_unit = RotaryMRDamper::TorqueUnit::lbf_in;
  damper.current_range = {0.0, 0.75};
  damper.assumed_below = 0.50;
  damper.highest_current = 1.5;
  damper.highest_speed = 12.566370614359172;
  damper.rated_torque = 4.0;
  damper.lowest_temperature = 238.15;
  damper.highest_temperature = 333.15;
}

inline RotaryMRDamper::RotaryMRDamper() {
  rd_2087_01(*this);
}

}  // namespace stepwire
