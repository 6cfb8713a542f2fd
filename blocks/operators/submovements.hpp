#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Movement composed of overlapping submovements. Every `interval` one of the duration `overlap` interval
/// begins. It leads from the last via point to the next one with minimum jerk, with s its time over its
/// duration:
///
///     m(s) = 10 s^3 - 15 s^4 + 6 s^5.
///
/// The next via point is at `step` from the last one, but at most at `reach` from the hand. The lead of the
/// last via point over the hand decays to exp(-interval/hold), except along `step`, and along `correction`
/// beside it. If the hand is led farther than `reach`, the excess decays as exp(-t/reflex).
struct Submovements {
  Input<2> step{}, position{}, correction{};
  Input<1> reach{};
  double interval = 0.3, overlap = 1.5, latency = 0.0, hold = unlimited, reflex = unlimited;
  Output<2> equilibrium{}, velocity{}, pending{};
  Output<1> begins{};
  DiscreteState<2> goal{};               ///< last via point
  DiscreteState<2> newer{}, older{};     ///< displacements of the two submovements that may be active
  DiscreteState<1> age{}, older_age{};   ///< times since their begin
  DiscreteState<1> waited{}, started{};  ///< time before the first submovement, and 1 after its begin
  Period period;

  void outputs() {
    const double duration = interval * overlap, s = age / duration, t = older_age / duration;
    for (Index i = 0; i < 2; ++i) {
      pending[i] = newer[i] * (1.0 - way(s)) + older[i] * (1.0 - way(t));
      equilibrium[i] = goal[i] - pending[i];
      velocity[i] = (newer[i] * rate(s) + older[i] * rate(t)) / duration;
    }
    begins = due() ? 1.0 : 0.0;
  }

  void update() {
    if (due()) begin();
    if (reach.connected()) let_go();
    age = age + period;
    older_age = older_age + period;
    waited = waited + period;
  }

  /// Starts without an active submovement.
  void start() { age = older_age = interval * overlap; }

  static void declare(Declare<Submovements>& is);

 private:
  static constexpr double tick = 1e-9;  // tolerance for sums of periods [s]
  static double way(double s) { return s >= 1.0 ? 1.0 : s * s * s * (10.0 + s * (6.0 * s - 15.0)); }
  static double rate(double s) { return s >= 1.0 ? 0.0 : 30.0 * s * s * (1.0 - s) * (1.0 - s); }
  bool due() const { return started != 0.0 ? age >= interval - tick : waited >= latency - tick; }

  void begin() {
    older = newer;
    older_age = age;
    const double behind[2] = {goal[0] - position[0], goal[1] - position[1]};
    const double length = fn::hypot(step[0], step[1]), kept = fn::exp(-interval / hold);
    const double along =
        length > 0.0 ? std::max(0.0, (behind[0] * step[0] + behind[1] * step[1]) / (length * length)) : 0.0;
    double ahead[2];
    for (Index i = 0; i < 2; ++i) ahead[i] = kept * behind[i] + ((1.0 - kept) * along + 1.0) * step[i];
    if (correction.connected())
      keep_correction({behind[0] - along * step[0], behind[1] - along * step[1]}, kept, ahead);
    const double far = fn::hypot(ahead[0], ahead[1]);
    const double share = reach.connected() && far > reach ? std::max(0.0, reach / far) : 1.0;
    for (Index i = 0; i < 2; ++i) {
      const double next = position[i] + share * ahead[i];
      newer[i] = next - goal[i];
      goal[i] = next;
    }
    age = 0.0;
    started = 1.0;
  }

  /// Keeps the lag of the hand along a correction. So a push against an obstacle increases with each
  /// submovement while the error lasts.
  void keep_correction(const std::array<double, 2>& beside, double kept, double* ahead) const {
    const double square = correction[0] * correction[0] + correction[1] * correction[1];
    const double along = beside[0] * correction[0] + beside[1] * correction[1];
    if (!(along > 0.0 && square > 0.0)) return;
    for (Index i = 0; i < 2; ++i) ahead[i] += (1.0 - kept) * along / square * correction[i];
  }

  void let_go() {
    const double x = goal[0] - position[0], y = goal[1] - position[1], far = fn::hypot(x, y);
    const double most = std::max(0.0, static_cast<double>(reach));
    if (!(far > most)) return;
    const double lost = -fn::expm1(-period / reflex) * (1.0 - most / far);
    goal[0] -= lost * x;
    goal[1] -= lost * y;
  }
};

}  // namespace stepwire
