#pragma once

#include <cmath>
#include <numbers>

#include "blocks/sources/own_time.hpp"
#include "engine/base/math/elementary.hpp"

namespace stepwire {

/// Sine wave: y = amplitude sin(2 pi frequency t + phase) + bias.
struct Sine : OwnTime {
  PerElement amplitude = 1.0, frequency = 1.0, phase = 0.0, bias = 0.0;
  Output<> y{};
  PerElement omega = 0.0;  ///< 2 pi frequency [rad/s]; doubling is exact, so 0.5 Hz gives pi to the last bit

  void prepare() {
    omega = frequency.map([](double f) { return 2.0 * std::numbers::pi * f; });
  }
  void update() { keep_origin(); }
  void configure(Configure& is);
  void outputs() {
    const double time = own();
    y.each([&](Index k) { return amplitude[k] * fn::sin(omega[k] * time + phase[k]) + bias[k]; });
  }

  static void declare(Declare<Sine>& is);
};

}  // namespace stepwire
