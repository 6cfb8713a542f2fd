#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Incremental encoder and the counter of the board that reads it: with q = 2 pi / counts_per_revolution,
///
///     counts = floor((angle - zero) / q + 1/2) modulo 2^bits, in 0 ... 2^bits - 1
struct QuadratureEncoder {
  PerElement counts_per_revolution = 4000.0, zero = 0.0;
  std::int64_t bits = 24;
  Input<> angle{};
  Output<> counts{};
  PerElement turn = 1.0;  ///< angle per count [rad]
  double levels = 2.0;    ///< count of the counter's values

  void prepare() {
    turn = counts_per_revolution.map([](double per_turn) { return 2.0 * std::numbers::pi / per_turn; });
    levels = std::ldexp(1.0, static_cast<int>(bits));
  }
  void outputs() {
    counts.each([&](Index i) { return wrapped(std::floor((angle[i] - zero[i]) / turn[i] + 0.5)); });
  }

  static void declare(Declare<QuadratureEncoder>& is);

 private:
  double wrapped(double count) const { return count - levels * std::floor(count / levels); }
};

inline void rig_encoder(QuadratureEncoder& encoder) {
  encoder.counts_per_revolution = 4000.0;
  encoder.bits = 24;
}

}  // namespace stepwire
