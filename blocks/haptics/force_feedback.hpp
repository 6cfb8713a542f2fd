#pragma once

#include <algorithm>
#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Force feedback for a joint that can only resist: the resistance that its damper is asked for,
///
///     y = |wanted| + kp e + I within [0, limit], e = |wanted| - |measured|, dI/dt = ki e, |I| <=
///     integral_limit,
///
/// while the wanted effort of the device opposes the measured one of the hand; else y = 0 and I starts anew.
struct ForceFeedback {
  PerElement kp = 1.0, ki = 30.0, integral_limit = unlimited, limit = unlimited, threshold = 0.0;
  Input<> wanted{}, measured{};
  Output<> y{}, realisable{};
  DiscreteState<> integral{};
  Period period{};

  void outputs() {
    y.each([&](Index i) { return resists(i) ? std::clamp(asked(i), 0.0, limit[i]) : 0.0; });
    realisable.each([&](Index i) { return resists(i) ? std::clamp(wanted[i], -limit[i], limit[i]) : 0.0; });
  }

  void update() {
    integral.each([&](Index i) { return resists(i) ? next_integral(i) : 0.0; });
  }

  static void declare(Declare<ForceFeedback>& is);

 private:
  bool pushes(Index i) const { return std::abs(measured[i]) > threshold[i]; }
  /// A hand that does not push yet may be resisted as soon as it does.
  bool resists(Index i) const { return wanted[i] != 0.0 && !(pushes(i) && wanted[i] * measured[i] > 0.0); }
  /// Before the hand pushes there is nothing to be compared with.
  double error(Index i) const { return pushes(i) ? std::abs(wanted[i]) - std::abs(measured[i]) : 0.0; }
  double asked(Index i) const { return std::abs(wanted[i]) + kp[i] * error(i) + integral[i]; }

  /// Waits while the damper is asked for more or for less than it can give.
  double next_integral(Index i) const {
    const double more = ki[i] * period * error(i);
    const bool is_stuck = more > 0.0 ? asked(i) >= limit[i] : asked(i) <= 0.0;
    return is_stuck ? static_cast<double>(integral[i])
                    : std::clamp(integral[i] + more, -integral_limit[i], integral_limit[i]);
  }
};

}  // namespace stepwire
