#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Angle of an encoder from the counts of a board, unwrapped over overflows of the counter: from tick to tick
///
///     angle += 2 pi / counts_per_revolution step, step = change of the counts, wrapped to half the counter
///
/// A step of more than `largest_step` is rejected. The angle then stays, and fault is 1 until the counts are
/// again within that step of the last accepted ones.
struct EncoderToAngle {
  PerElement counts_per_revolution = 4000.0, zero = 0.0, largest_step = unlimited;
  std::int64_t bits = 24;
  Input<> counts{};
  Output<> angle{}, fault{};
  DiscreteState<> last{}, total{};
  DiscreteState<1> begun{};
  Diagnostic jumped{};
  Time time{};
  PerElement turn = 1.0;  ///< angle per count [rad]
  double levels = 2.0;    ///< count of the counter's values

  void prepare() {
    turn = counts_per_revolution.map([](double per_turn) { return 2.0 * std::numbers::pi / per_turn; });
    levels = std::ldexp(1.0, static_cast<int>(bits));
  }
  void outputs() {
    angle.each([&](Index i) { return zero[i] + turn[i] * (total[i] + believed(i)); });
    fault.each([&](Index i) { return is_jump(i) ? 1.0 : 0.0; });
  }
  void update() {
    for (Index i = 0; i < counts.size(); ++i) {
      if (is_jump(i)) {
        jumped.raise(time);
      } else {
        total[i] = total[i] + step(i);
        last[i] = counts[i];
      }
    }
    begun = 1.0;
  }

  static void declare(Declare<EncoderToAngle>& is);

 private:
  double step(Index i) const {
    const double change = counts[i] - last[i];
    return change - levels * std::floor(change / levels + 0.5);
  }
  bool is_on_counter(Index i) const { return counts[i] >= 0.0 && counts[i] < levels; }
  /// True for a rejected step. A step of half the counter has no sign. At the first tick any position is
  /// accepted, since it is unknown before.
  bool is_jump(Index i) const {
    const double size = std::abs(step(i));
    const bool near = begun == 0.0 || (size < 0.5 * levels && size <= largest_step[i]);
    return !(is_on_counter(i) && near);
  }
  double believed(Index i) const { return is_jump(i) ? 0.0 : step(i); }
};

inline void rig_encoder_reading(EncoderToAngle& encoder) {
  encoder.counts_per_revolution = 4000.0;
  encoder.bits = 24;
}

}  // namespace stepwire
