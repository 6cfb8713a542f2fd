#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Energy balance of a port. With the power F . v that flows in,
///
///     supplied = integral of F . v,   dissipated = supplied + booked - (stored - stored at the start)
///
/// A device is passive if it returns no more energy than it has received, dissipated >= 0. A dissipative
/// device never returns dissipated energy, so that `dissipated` never decreases. `broken` reports a violation
/// by more than `budget`.
struct PassivityObserver {
  enum class Judge { net, fall };

  Judge judge = Judge::net;
  double budget = 0.0;
  Input<> force{}, velocity{};
  Input<1> stored{}, booked{};
  Output<1> supplied{}, dissipated{}, least_gain{}, broken{};
  State<1> energy{};
  DiscreteState<1> first_stored{}, before{}, highest{}, least{}, begun{};
  Diagnostic gave_out{};
  Time time{};

  void outputs() {
    const double lost = lost_now();
    supplied = energy;
    dissipated = lost;
    least_gain = std::min<double>(least, lost - before);
    broken = exceeded(lost) ? 1.0 : 0.0;
  }
  void derivatives() {
    double power = 0.0;
    for (Index i = 0; i < force.size(); ++i) power += force[i] * velocity[i];
    energy.derivative = power;
  }
  void update() {
    const double lost = lost_now();
    if (begun == 0.0 && stored.connected()) first_stored = stored;
    if (exceeded(lost)) gave_out.raise(time);
    least = least_gain;
    highest = std::max<double>(highest, lost);
    before = lost;
    begun = 1.0;
  }

  static void declare(Declare<PassivityObserver>& is);

 private:
  double lost_now() const {
    double lost = energy;
    if (stored.connected() && begun > 0.0) lost -= stored - first_stored;
    if (booked.connected()) lost += booked;
    return lost;
  }
  /// True if more energy than the budget has been returned beyond the supplied, or with `fall` beyond the
  /// highest dissipated one.
  bool exceeded(double lost) const { return (judge == Judge::net ? -lost : highest - lost) > budget; }
};

}  // namespace stepwire
