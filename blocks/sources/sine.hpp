#pragma once

#include <cmath>
#include <numbers>

#include "engine/block/declare.hpp"

namespace stepwire {

/// A sine wave: y = amplitude sin(2 pi frequency t + phase) + bias.
struct Sine {
  PerElement amplitude = 1.0, frequency = 1.0, phase = 0.0, bias = 0.0;
  Output<> y{};
  Time t{};
  Eigen::ArrayXd omega{};  ///< 2 pi frequency [rad/s]; doubling is exact, so 0.5 Hz gives pi to the last bit

  void start() { omega = 2.0 * std::numbers::pi * frequency; }
  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k)
      y.coeffRef(k) = amplitude.coeff(k) * std::sin(omega.coeff(k) * t + phase.coeff(k)) + bias.coeff(k);
  }

  static void declare(Declare<Sine>& is);
};

}  // namespace stepwire
