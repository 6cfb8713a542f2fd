#pragma once

#include <algorithm>
#include <cstdint>

#include "blocks/hardware/gauge_calibration.hpp"
#include "engine/base/math/normal_quantile.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Six-axis load cell: the voltages of its strain gauges, with the calibration C of its certificate,
///
///     gauges = C^-1 [force / N, torque / (N m)] + offset + noise w, within -range ... range
///
/// where w is normal noise of variance 1, a sequence for each gauge.
struct LoadCell {
  Matrix calibration{};
  PerElement offset = 0.0, noise = 0.0;
  double range = 10.0;
  std::int64_t seed = 0;
  Input<3> force{}, torque{};
  Output<6> gauges{};
  DiscreteState<1> sample{};
  Diagnostic overloaded{};
  Time time{};
  Matrix response{};  ///< inverse of the calibration

  void configure(Configure& is);
  void prepare();
  void outputs() {
    STEPWIRE_UNROLLED
    for (Index i = 0; i < 6; ++i)
      gauges[i] = std::clamp(strained(i) + offset[i] + deviation(i), -range, range);
  }
  void update() {
    for (Index i = 0; i < 6; ++i)
      if (std::abs(strained(i) + offset[i]) > range) overloaded.raise(time);
    sample = sample + 1.0;
  }

  static void declare(Declare<LoadCell>& is);

 private:
  double strained(Index i) const {
    double sum = 0.0;
    STEPWIRE_UNROLLED
    for (Index k = 0; k < 3; ++k) sum += response(i, k) * force[k] + response(i, k + 3) * torque[k];
    return sum;
  }
  double deviation(Index i) const {
    return noise[i] > 0.0 ? noise[i] * normal_quantile(even_sample(seed, i, sample)) : 0.0;
  }
};

/// Noise as measured at 1 kHz, 0.015 N along x and y; 10 V at full load on all axes.
inline void ati_mini40_si_80_4(LoadCell& cell) {
  cell.calibration = three_beams(80.0, 240.0, 4.0);
  cell.noise = 0.9e-3;
}

/// The noise in volts is assumed to be that of the SI-80-4.
inline void ati_mini40_si_40_2(LoadCell& cell) {
  cell.calibration = three_beams(40.0, 120.0, 2.0);
  cell.noise = 0.9e-3;
}

}  // namespace stepwire
