#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Converter from volts to counts: with q = 2 range / 2^bits,
///
///     counts = floor(u / q + 1/2) within -2^(bits - 1) ... 2^(bits - 1) - 1
struct AnalogToDigital {
  PerElement range = 10.0;
  std::int64_t bits = 14;
  Input<> u{};
  Output<> counts{};
  Diagnostic out_of_range{};
  Time time{};
  double most = 1.0;  ///< counts at the voltage `range`

  void prepare() { most = std::ldexp(1.0, static_cast<int>(bits - 1)); }
  void outputs() {
    counts.each([&](Index i) { return std::clamp(nearest(i), -most, most - 1.0); });
  }
  void update() {
    for (Index i = 0; i < u.size(); ++i)
      if (nearest(i) < -most || nearest(i) > most) out_of_range.raise(time);
  }

  static void declare(Declare<AnalogToDigital>& is);

 private:
  double nearest(Index i) const { return std::floor(u[i] / range[i] * most + 0.5); }
};

/// Inputs and outputs of -10 to 10 V in steps of 1.2 mV; the inputs may be set to -5 to 5 V instead.
inline void sensoray_626(AnalogToDigital& converter) {
  converter.range = 10.0;
  converter.bits = 14;
}

}  // namespace stepwire
