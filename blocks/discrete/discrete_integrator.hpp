#pragma once

#include <algorithm>

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Discrete integrator within limits, with one of three approximations of an integral.
struct DiscreteIntegrator : Resettable {
  enum class Method { forward_euler, backward_euler, trapezoidal };

  PerElement gain = 1.0, lower = -unlimited, upper = unlimited;
  Method method = Method::forward_euler;
  Input<> u{};
  Output<> y{};
  DiscreteState<> x{};
  Period period{};

  double before = 0.0, after = 1.0;  // shares of u T that are added before and after the output

  void outputs() {
    y.each([&](Index i) { return sum(i); });
  }

  void update() {
    for (Index i = 0; i < x.size(); ++i) x[i] = sum(i) + after * increment(i);
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<DiscreteIntegrator>& is);

 private:
  double increment(Index i) const { return gain[i] * period * u[i]; }
  double sum(Index i) const {
    // An unneeded input is not read, since it may be computed later.
    const double past = resetting() ? target(i) : x[i];
    const double all = before == 0.0 ? past : past + before * increment(i);
    return std::clamp(all, lower[i], upper[i]);
  }
};

}  // namespace stepwire
