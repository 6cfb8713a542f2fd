#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"
#include "engine/model/signal/texts.hpp"

namespace stepwire {

/// Passes commands on while there is no fault: y = share u, where `share` rises linearly from 0 to 1 within
/// `ramp`. It is 0 from the tick of a fault until a reset, and while the dead-man switch is released.
struct Interlock {
  Texts causes{};
  double ramp = 0.1;
  bool stop = false;
  Input<> u{};
  Inputs faults{}, measured{};
  Input<1> dead_man{}, reset{};
  Output<> y{};
  Output<1> cause{};
  DiscreteState<1> latched{}, first{}, share{}, last_reset{};
  Diagnostic tripped{}, stopped{};
  Time time{};
  Period period{};

  void outputs() {
    cause = cause_now();
    const double part = is_free() ? eased() : 0.0;
    y.each([&](Index i) { return part > 0.0 ? part * u[i] : 0.0; });
  }
  void update() {
    if (cause > 0.0) trip();
    share = is_free() ? std::fmin(1.0, eased() + step()) : 0.0;
    latched = cause_now();
    last_reset = resetting() ? 1.0 : 0.0;
  }

  void configure(Configure& is);
  static void declare(Declare<Interlock>& is);

  /// Number of the cause for a non-finite number; those of `faults` follow.
  static constexpr double not_finite = 1.0;

 private:
  bool resetting() const { return reset.connected() && reset > 0.0; }
  bool is_held() const { return !dead_man.connected() || dead_man > 0.0; }
  bool is_free() const { return is_held() && cause_now() == 0.0; }
  double eased() const { return ramp > 0.0 ? static_cast<double>(share) : 1.0; }
  double step() const { return ramp > 0.0 ? period / ramp : 1.0; }

  /// Returns the present cause. Only the rising edge of the reset counts, so that a stuck reset hides no
  /// fault.
  double cause_now() const {
    const bool is_reset = resetting() && last_reset == 0.0;
    return latched > 0.0 && !is_reset ? static_cast<double>(latched) : present_fault();
  }
  double present_fault() const {
    if (!all_finite()) return not_finite;
    for (Index k = 0; k < faults.count(); ++k)
      if (!(faults.first(k) <= 0.0)) return not_finite + static_cast<double>(k + 1);
    return 0.0;
  }
  bool all_finite() const {
    for (Index i = 0; i < u.size(); ++i)
      if (!std::isfinite(u[i])) return false;
    for (Index k = 0; k < measured.count(); ++k)
      for (Index i = 0; i < measured[k].size; ++i)
        if (!std::isfinite(measured[k][i])) return false;
    return true;
  }
  void trip() {
    if (first == 0.0) first = static_cast<double>(cause);
    (stop ? stopped : tripped).raise(time);
  }
};

}  // namespace stepwire
