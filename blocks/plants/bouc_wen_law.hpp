#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

/// Coefficients of a Bouc-Wen law.
struct BoucWenFactors {
  double A = 1.0, beta = 0.0, gamma = 0.0;
};

/// Bouc-Wen evolution of a hysteretic variable z under the velocity v = dx/dt,
///
///     dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n,
///
/// and its energy. An element of force alpha z stores alpha z^2 / (2 A) and dissipates alpha/A times lost(v,
/// z), which is never negative if and only if A > 0 and beta >= |gamma|.
struct BoucWenLaw : BoucWenFactors {
  double n = 1.0;

  /// Variable z after some travel, and the integral of lost() on the path.
  struct Travelled {
    double z, lost;
  };

  /// Returns |z|^n.
  double power(double z) const { return n == 1.0 ? std::abs(z) : fn::pow(std::abs(z), n); }

  /// Returns dz/dt.
  double rate(double v, double z) const {
    const double p = power(z);
    return A * v - beta * std::abs(v) * std::copysign(p, z) - gamma * v * p;
  }

  double lost(double v, double z) const { return power(z) * (beta * std::abs(v * z) + gamma * v * z); }

  /// Returns the law with this limit of z in a steady motion and this gamma/beta.
  static BoucWenLaw of_limit(double A, double limit, double ratio, double n) {
    const double beta = A / fn::pow(limit, n) / (1.0 + ratio);
    return {{A, beta, ratio * beta}, n};
  }

  /// Returns the limit of z in a steady motion; requires beta + gamma > 0.
  double limit() const { return fn::pow(A / (beta + gamma), 1.0 / n); }

  /// Solves over a time in which the velocity changes linearly from v0 to v1. The result is exact for n = 1,
  /// else by substeps (see forward_by_steps), and stable for any travel if beta >= |gamma|. The law depends
  /// on travel and not on time; if the motion reverses in between, both parts are integrated.
  Travelled over(double z, double v0, double v1, double duration) const {
    if (!(v0 * v1 < 0.0)) return travel(z, 0.5 * (v0 + v1) * duration);
    const double turn = duration * v0 / (v0 - v1);
    const Travelled out = travel(z, 0.5 * v0 * turn);
    const Travelled back = travel(out.z, 0.5 * v1 * (duration - turn));
    return {back.z, out.lost + back.lost};
  }

  /// Solves over a travel dx in one direction.
  Travelled travel(double z, double dx) const {
    if (dx >= 0.0) return forward(z, dx);
    const Travelled mirrored = forward(-z, -dx);
    return {-mirrored.z, mirrored.lost};
  }

 private:
  /// Solves for dx >= 0, where dz/dx = A - k z with k = beta - gamma below zero and beta + gamma above it.
  Travelled forward(double z, double dx) const {
    if (n != 1.0) return forward_by_steps(z, dx);
    if (z >= 0.0) return relax(z, dx, beta + gamma);
    const double to_zero = distance_to_zero(z);
    if (dx < to_zero) return relax(z, dx, beta - gamma);
    const Travelled below = relax(z, to_zero, beta - gamma);
    const Travelled above = relax(0.0, dx - to_zero, beta + gamma);
    return {above.z, below.lost + above.lost};
  }

  /// Solves dz/dx = A - k |z|^(n-1) z for any n.
  ///
  /// Uses exponential Rosenbrock steps of third order (exprb32; M. Hochbruck, A. Ostermann, J. Schweitzer
  /// 2009), each of which changes z by a small part of its limit. They are exact where the law is linear. So
  /// the steady motion takes one step for any stiffness.
  Travelled forward_by_steps(double z, double dx) const {
    const double part = 1.0 / (48.0 * n), stiffest = beta + std::abs(gamma);
    const double least = stiffest > 0.0 ? part * fn::pow(A / stiffest, 1.0 / n) : dx * A;
    Travelled way{z, 0.0};
    for (double left = dx; left > 0.0;) {
      double change = std::max(least, part * std::abs(way.z));
      // Steps end shortly after zero, where the law has a kink.
      if (way.z < 0.0) change = std::max(std::min(change, -way.z), 0.1 * least);
      const Tangent tangent = tangent_at(way.z);
      const double h = std::min(left, reach(tangent, change));
      const Travelled step = rosenbrock(way.z, tangent, h);
      way = {step.z, way.lost + step.lost};
      left -= h;
    }
    return way;
  }

  /// Linearisation of the law near some z for dx > 0: dz/dx, and its decrease with z, which is never
  /// negative.
  struct Tangent {
    double slope, fall;
  };

  Tangent tangent_at(double z) const {
    // the only power, which is most of the cost of a step
    const double k = (z < 0.0 ? beta - gamma : beta + gamma) * fn::pow(std::abs(z), n - 1.0);
    return {A - k * z, k * n};
  }

  /// Returns the travel after which z has changed by `change` in the linearised law; infinite if it never
  /// does.
  static double reach(const Tangent& tangent, double change) {
    const double s = std::abs(tangent.slope), j = tangent.fall;
    if (change * j >= s) return std::numeric_limits<double>::infinity();
    return j > 0.0 ? -fn::log1p(-change * j / s) / j : change / s;
  }

  Travelled rosenbrock(double z, const Tangent& tangent, double h) const {
    const double s = tangent.slope, j = tangent.fall, y = j * h, decay = mean_of_decay(y),
                 rise = mean_of_rise(y, decay);
    const double linear = z + s * h * decay;
    const double bend = tangent_at(linear).slope - s + j * (linear - z);
    const double correction = 2.0 * h * third(y, rise) * bend, end = linear + correction;
    const double mean = z + s * h * rise + 0.25 * correction;  // cubic in the travel
    return {end, std::max(0.0, A * h * mean - 0.5 * (end - z) * (end + z))};
  }

  double distance_to_zero(double z) const {
    const double k = beta - gamma;
    return k == 0.0 ? -z / A : fn::log1p(-z * k / A) / k;
  }

  /// Solves dz/dx = A - k z. The loss, the integral of k z^2, is the work A z minus the gain of z^2/2.
  Travelled relax(double z, double dx, double k) const {
    const double slope = (A - k * z) * dx;
    const double mean_rise = mean_of_decay(k * dx);
    const double end = z + slope * mean_rise;
    const double mean = z + slope * mean_of_rise(k * dx, mean_rise);
    return {end, std::max(0.0, A * dx * mean - 0.5 * (end - z) * (end + z))};
  }

  /// Returns (1 - exp(-s)) / s.
  static double mean_of_decay(double s) { return s == 0.0 ? 1.0 : -fn::expm1(-s) / s; }

  /// Returns (1 - (1 - exp(-s)) / s) / s; by its series near zero, where the difference would cancel.
  static double mean_of_rise(double s, double decay) {
    if (s > 0.01) return (1.0 - decay) / s;
    return 1.0 / 2 - s * (1.0 / 6 - s * (1.0 / 24 - s * (1.0 / 120 - s / 720)));
  }

  /// Returns (1/2 - mean_of_rise(s)) / s.
  static double third(double s, double rise) {
    if (s > 0.01) return (0.5 - rise) / s;
    return 1.0 / 6 - s * (1.0 / 24 - s * (1.0 / 120 - s / 720));
  }
};

}  // namespace stepwire
