#pragma once

#include <algorithm>

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Integral of its input: dx/dt = u, y = x, optionally with limits and a reset.
struct Integrator : Resettable {
  // Members of every step are adjacent in memory; most integrators have neither limits nor a reset.
  Input<> u{};
  State<> x{};
  bool slope_is_input = true, limited = false;

  PerElement lower = -unlimited, upper = unlimited;
  Output<> y{}, before{};
  DiscreteState<> stop{};  // 1 at the upper and -1 at the lower limit at the last tick, else 0

  void outputs() { show(held()); }
  void outputs_at_instant() { show(resetting()); }

  void derivatives() {
    if (slope_is_input) {
      x.derivative = u;
    } else {
      integrate_within_limits();
    }
  }

  void update_before_instant() { follow_target(x); }
  void update() {
    const bool now = resetting();
    for (Index i = 0; i < x.size(); ++i) {
      x[i] = limit(now ? target(i) : x[i], i);
      stop[i] = x[i] >= upper[i] ? 1.0 : x[i] <= lower[i] ? -1.0 : 0.0;
    }
    remember_reset();
  }

  /// A limit is met where the integral reaches it, and left where the input turns inward.
  void crossings(Crossings& zero) const {
    Resettable::crossings(zero);
    for (Index i = 0; i < x.size(); ++i) {
      zero.add(stop[i] < 0.0 ? u[i] : x[i] - lower[i]);
      zero.add(stop[i] > 0.0 ? u[i] : x[i] - upper[i]);
    }
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<Integrator>& is);

 private:
  void show(bool at_target) {
    for (Index i = 0; i < y.size(); ++i) y[i] = limit(at_target ? target(i) : x[i], i);
  }
  STEPWIRE_RARE void integrate_within_limits() {
    const bool still = held();
    for (Index i = 0; i < x.size(); ++i) x.derivative[i] = still ? 0.0 : gated(u[i], i);
  }
  double limit(double number, Index i) const { return std::clamp(number, lower[i], upper[i]); }
  /// Stops the integration at a limit for whole steps; a change within a step would reduce the solver's
  /// order.
  double gated(double rate, Index i) const { return stop[i] * rate > 0.0 ? 0.0 : rate; }
};

}  // namespace stepwire
