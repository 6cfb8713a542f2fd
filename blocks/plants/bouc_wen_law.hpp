#pragma once

#include <algorithm>
#include <cmath>

namespace stepwire {

/// Bouc-Wen evolution of a hysteretic variable z under the velocity v = dx/dt,
///
///     dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n,
///
/// and its energy: an element of force alpha z stores alpha z^2 / (2 A) and loses alpha/A times lost(v, z),
/// which is never negative if and only if A > 0 and beta >= |gamma|.
struct BoucWenLaw {
  double A = 1.0, beta = 0.0, gamma = 0.0, n = 1.0;

  /// z after some travel, and the integral of lost() on the way.
  struct Travelled {
    double z, lost;
  };

  /// |z|^n
  double power(double z) const { return n == 1.0 ? std::abs(z) : std::pow(std::abs(z), n); }

  /// dz/dt
  double rate(double v, double z) const {
    const double p = power(z);
    return A * v - beta * std::abs(v) * std::copysign(p, z) - gamma * v * p;
  }

  double lost(double v, double z) const { return power(z) * (beta * std::abs(v * z) + gamma * v * z); }

  /// Where z settles in a steady motion; only for beta + gamma > 0.
  double limit() const { return std::pow(A / (beta + gamma), 1.0 / n); }

  /// Exact solution for n = 1 over a time in which the velocity goes in a straight line from v0 to v1. The
  /// law knows no time, only travel: where the motion turns back in between, both ways count.
  Travelled over(double z, double v0, double v1, double duration) const {
    if (!(v0 * v1 < 0.0)) return travel(z, 0.5 * (v0 + v1) * duration);
    const double turn = duration * v0 / (v0 - v1);
    const Travelled out = travel(z, 0.5 * v0 * turn);
    const Travelled back = travel(out.z, 0.5 * v1 * (duration - turn));
    return {back.z, out.lost + back.lost};
  }

  /// Exact solution for n = 1 over a travel dx in one direction.
  Travelled travel(double z, double dx) const {
    if (dx >= 0.0) return forward(z, dx);
    const Travelled mirrored = forward(-z, -dx);
    return {-mirrored.z, mirrored.lost};
  }

 private:
  /// For dx >= 0 the law is dz/dx = A - k z with k = beta - gamma below zero and beta + gamma above it.
  Travelled forward(double z, double dx) const {
    if (z >= 0.0) return relax(z, dx, beta + gamma);
    const double to_zero = distance_to_zero(z);
    if (dx < to_zero) return relax(z, dx, beta - gamma);
    const Travelled below = relax(z, to_zero, beta - gamma);
    const Travelled above = relax(0.0, dx - to_zero, beta + gamma);
    return {above.z, below.lost + above.lost};
  }

  double distance_to_zero(double z) const {
    const double k = beta - gamma;
    return k == 0.0 ? -z / A : std::log1p(-z * k / A) / k;
  }

  /// dz/dx = A - k z. The loss, the integral of k z^2, is the work A z minus what z^2/2 gained.
  Travelled relax(double z, double dx, double k) const {
    const double slope = (A - k * z) * dx;
    const double mean_rise = mean_of_decay(k * dx);
    const double end = z + slope * mean_rise;
    const double mean = z + slope * mean_of_rise(k * dx, mean_rise);
    return {end, std::max(0.0, A * dx * mean - 0.5 * (end - z) * (end + z))};
  }

  /// (1 - exp(-s)) / s
  static double mean_of_decay(double s) { return s == 0.0 ? 1.0 : -std::expm1(-s) / s; }

  /// (1 - (1 - exp(-s)) / s) / s; its series near zero, where the difference would lose its digits.
  static double mean_of_rise(double s, double decay) {
    if (s > 0.01) return (1.0 - decay) / s;
    return 1.0 / 2 - s * (1.0 / 6 - s * (1.0 / 24 - s * (1.0 / 120 - s / 720)));
  }
};

}  // namespace stepwire
