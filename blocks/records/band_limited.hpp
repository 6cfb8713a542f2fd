#pragma once

#include <array>
#include <cmath>
#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// Unique periodic signal through given samples without content above half of the sample rate, at any
/// instant.
///
/// The samples are refined sixteen times by a discrete Fourier transform, which is exact. The fastest line
/// then has at least 32 refined samples per period. Between them a polynomial of degree 11 interpolates the
/// nearest twelve. Its error is below (pi/16)^12 (1/2 3/2 ... 11/2)^2 / 12! = 2e-13 of the sum of the
/// amplitudes of all lines.
class BandLimited {
 public:
  static constexpr Index refinement = 16;

  /// Returns the signals through one period of evenly spaced samples, a row for each signal. The next period
  /// begins one interval after the last sample.
  static BandLimited through(const Matrix& samples);

  /// Returns the value of a signal `turns` periods after the first sample; `turns` may be any number.
  double operator()(Index signal, double turns) const {
    const double place = (turns - std::floor(turns)) * length;
    const double below = std::floor(place);
    return interpolate(fine.elements().data() + signal * fine.rows() + static_cast<Index>(below),
                       place - below);
  }

  double length = 1.0;  ///< refined samples in a period
  Matrix fine;          ///< a column for each signal, with additional samples at both ends for the polynomial

 private:
  static constexpr int points = 12, before = points / 2 - 1;

  /// Returns one over the product of each point's distances to the others.
  static constexpr std::array<double, points> weights() {
    std::array<double, points> result{};
    for (int j = 0; j < points; ++j) {
      double product = 1.0;
      for (int i = 0; i < points; ++i)
        if (i != j) product *= j - i;
      result[static_cast<std::size_t>(j)] = 1.0 / product;
    }
    return result;
  }

  /// Evaluates Lagrange's polynomial through around[0...11] at the fraction `share` from around[5] to
  /// around[6].
  static double interpolate(const double* around, double share) {
    constexpr std::array<double, points> weight = weights();
    std::array<double, points> below;  // product of the distances to the previous points
    double product = 1.0;
    for (int j = 0; j < points; ++j) {
      below[static_cast<std::size_t>(j)] = product;
      product *= share - (j - before);
    }
    double sum = 0.0, above = 1.0;
    for (int j = points - 1; j >= 0; --j) {
      sum += around[j] * weight[static_cast<std::size_t>(j)] * below[static_cast<std::size_t>(j)] * above;
      above *= share - (j - before);
    }
    return sum;
  }
};

}  // namespace stepwire
