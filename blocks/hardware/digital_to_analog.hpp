#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Converter from counts to volts: y = range / 2^(bits - 1) counts, of whole counts within -2^(bits - 1) ...
/// 2^(bits - 1) - 1.
struct DigitalToAnalog {
  PerElement range = 10.0;
  std::int64_t bits = 14;
  Input<> counts{};
  Output<> y{};
  double most = 1.0;  ///< counts at the voltage `range`

  void prepare() { most = std::ldexp(1.0, static_cast<int>(bits - 1)); }
  void outputs() {
    y.each([&](Index i) {
      return range[i] / most * std::clamp(std::floor(counts[i] + 0.5), -most, most - 1.0);
    });
  }

  static void declare(Declare<DigitalToAnalog>& is);
};

inline void sensoray_626(DigitalToAnalog& converter) {
  converter.range = 10.0;
  converter.bits = 14;
}

}  // namespace stepwire
