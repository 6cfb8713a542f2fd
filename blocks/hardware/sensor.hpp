#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/base/math/elementary.hpp"
#include "engine/base/math/normal_quantile.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Analogue sensor and the converter that reads it, at its ticks. With x = u - zero, its output is
///
///     y = zero + interval round((held(x + linearity span sin(2 pi (x - lower) / span)) + noise w) /
///     interval)
///
/// where held() limits to [lower, upper], span = upper - lower, w is normal noise of variance 1 and interval
/// = converter_range / 2^bits.
struct Sensor {
  PerElement zero = 0.0, lower = -unlimited, upper = unlimited, linearity = 0.0, noise = 0.0;
  PerElement converter_range = 0.0;
  std::int64_t bits = 0, seed = 0;
  Input<> u{};
  Output<> y{};
  DiscreteState<1> sample{};
  Diagnostic out_of_range{};
  Time time{};
  PerElement interval = 0.0;  ///< between two levels of the converter; 0: no converter

  void prepare() {
    const double levels = std::ldexp(1.0, static_cast<int>(bits));
    interval = converter_range.map([&](double range) { return range / levels; });
  }
  void outputs() {
    y.each([&](Index i) { return zero[i] + converted(shown(u[i] - zero[i], i), i); });
  }
  void update() {
    for (Index i = 0; i < u.size(); ++i)
      if (u[i] - zero[i] < lower[i] || u[i] - zero[i] > upper[i]) out_of_range.raise(time);
    sample = sample + 1.0;
  }

  void configure(Configure& is);
  static void declare(Declare<Sensor>& is);

 private:
  double shown(double x, Index i) const {
    const double deviation = linearity[i] > 0.0 ? deviation_at(x, i) : 0.0;
    const double held = std::clamp(x + deviation, lower[i], upper[i]);
    return noise[i] > 0.0 ? held + noise[i] * normal_quantile(even_sample(seed, i, sample)) : held;
  }
  /// Returns the nonlinearity: one sine period over the range, with zeros at both ends and in the middle.
  double deviation_at(double x, Index i) const {
    const double span = upper[i] - lower[i];
    return linearity[i] * span * fn::sin(2.0 * std::numbers::pi * (x - lower[i]) / span);
  }
  double converted(double x, Index i) const {
    return interval[i] > 0.0 ? interval[i] * std::floor(x / interval[i] + 0.5) : x;
  }
};

/// The stroke is that of the datasheet. Assumed: linearity of 1 %, 10 V over the stroke, read by a 14-bit
/// converter of -10 to 10 V (Sensoray 626) with 0.05 mm of noise.
inline void celesco_mlp_75(Sensor& sensor) {
  sensor.lower = 0.0;
  sensor.upper = 75e-3;
  sensor.linearity = 0.01;
  sensor.noise = 0.05e-3;
  sensor.converter_range = 150e-3;
  sensor.bits = 14;
}

/// The axes x and y; -10 to 10 V over the range, read by a 14-bit converter. The noise was measured at 1 kHz.
inline void ati_mini40_si_80_4(Sensor& sensor) {
  sensor.lower = -80.0;
  sensor.upper = 80.0;
  sensor.noise = 0.015;
  sensor.converter_range = 160.0;
  sensor.bits = 14;
}

/// Half the range of the SI-80-4. Its noise is assumed to be half as well.
inline void ati_mini40_si_40_2(Sensor& sensor) {
  sensor.lower = -40.0;
  sensor.upper = 40.0;
  sensor.noise = 0.0075;
  sensor.converter_range = 80.0;
  sensor.bits = 14;
}

}  // namespace stepwire
