#pragma once

#include "blocks/hardware/gauge_calibration.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Force and torque from the voltages of a load cell's gauges: [force, torque] = C (gauges - bias). The bias
/// is `offset` until the first tare. While `tare` is true, it is the mean of the voltages since then.
struct LoadCellToWrench {
  Matrix calibration{};
  PerElement offset = 0.0;
  double range = 10.0;
  Input<6> gauges{};
  Input<1> tare{};
  Output<3> force{}, torque{};
  Output<1> saturated{};
  DiscreteState<6> sum{};
  DiscreteState<1> count{}, taring{};

  void configure(Configure& is);
  void outputs() {
    for (Index k = 0; k < 3; ++k) {
      force[k] = loaded(k);
      torque[k] = loaded(k + 3);
    }
    saturated = is_saturated() ? 1.0 : 0.0;
  }
  /// Accumulates the mean of a tare, which starts at its rising edge.
  void update() {
    if (is_taring()) {
      for (Index i = 0; i < 6; ++i) sum[i] = before(i) + gauges[i];
      count = samples();
    }
    taring = is_taring() ? 1.0 : 0.0;
  }

  static void declare(Declare<LoadCellToWrench>& is);

 private:
  bool is_taring() const { return tare.connected() && tare > 0.0; }
  bool begins() const { return is_taring() && taring == 0.0; }
  double before(Index i) const { return begins() ? 0.0 : static_cast<double>(sum[i]); }
  double samples() const { return (begins() ? 0.0 : static_cast<double>(count)) + 1.0; }
  /// Returns the estimate of the voltages without a load.
  double bias(Index i) const {
    if (is_taring()) return (before(i) + gauges[i]) / samples();
    return count > 0.0 ? sum[i] / count : offset[i];
  }
  double loaded(Index row) const {
    double total = 0.0;
    for (Index i = 0; i < 6; ++i) total += calibration(row, i) * (gauges[i] - bias(i));
    return total;
  }
  bool is_saturated() const {
    for (Index i = 0; i < 6; ++i)
      if (!(gauges[i] < range && gauges[i] > -range)) return true;
    return false;
  }
};

inline void ati_mini40_si_80_4(LoadCellToWrench& reading) {
  reading.calibration = three_beams(80.0, 240.0, 4.0);
}

inline void ati_mini40_si_40_2(LoadCellToWrench& reading) {
  reading.calibration = three_beams(40.0, 120.0, 2.0);
}

}  // namespace stepwire
