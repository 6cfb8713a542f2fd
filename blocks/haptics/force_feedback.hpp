#pragma once

#include <algorithm>
#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Force feedback for a joint that can only resist. The commanded resistance of its damper is
///
///     y = |wanted| + kp e + I within [0, limit], e = |wanted| - |measured|, dI/dt = ki e, |I| <=
///     integral_limit,
///
/// while the desired effort of the device opposes the measured one of the hand. Otherwise y = 0 and I is
/// reset.
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
  /// True if the effort may resist, also before the hand pushes, so that it acts at once when it does.
  bool resists(Index i) const { return wanted[i] != 0.0 && !(pushes(i) && wanted[i] * measured[i] > 0.0); }
  /// Returns the error; 0 before the hand pushes, when there is no measurement to compare with.
  double error(Index i) const { return pushes(i) ? std::abs(wanted[i]) - std::abs(measured[i]) : 0.0; }
  double asked(Index i) const { return std::abs(wanted[i]) + kp[i] * error(i) + integral[i]; }

  /// Returns the next integral, which is frozen while the command is outside of the damper's range.
  double next_integral(Index i) const {
    const double more = ki[i] * period * error(i);
    const bool is_stuck = more > 0.0 ? asked(i) >= limit[i] : asked(i) <= 0.0;
    return is_stuck ? static_cast<double>(integral[i])
                    : std::clamp(integral[i] + more, -integral_limit[i], integral_limit[i]);
  }
};

}  // namespace stepwire
