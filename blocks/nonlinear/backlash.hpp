#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Backlash of a gear: the output moves only while the input pushes it at one end of the gap.
struct Backlash : Resettable {
  PerElement width = 1.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> last{};

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) y[i] = pushed(i, resetting());
  }

  void update_before_instant() {
    for (Index i = 0; held() && i < last.size(); ++i) last[i] = pushed(i, true);
  }
  void update() {
    for (Index i = 0; i < last.size(); ++i) last[i] = pushed(i, resetting());
    remember_reset();
  }

  void crossings(Crossings& zero) const {
    Resettable::crossings(zero);
    for (Index i = 0; i < u.size(); ++i) {
      if (width[i] == 0.0) {  // the gap is never open
        zero.add(1.0);
        zero.add(1.0);
        continue;
      }
      const double rounding = epsilon * (std::abs(u[i]) + std::abs(last[i]) + width[i]);
      zero.add(u[i] - width[i] / 2.0 - last[i] + rounding);
      zero.add(last[i] - u[i] - width[i] / 2.0 + rounding);
    }
  }

  void configure(Configure& is);
  void start() { home = last; }

  static void declare(Declare<Backlash>& is);

 private:
  /// Margin of the crossing functions. While the output is pushed, they are 0 up to rounding, and must count
  /// as above 0.
  static constexpr double epsilon = 4.0 * std::numeric_limits<double>::epsilon();
  double pushed(Index i, bool at_target) const {
    const double half = width[i] / 2.0;
    return std::clamp(at_target ? target(i) : last[i], u[i] - half, u[i] + half);
  }
};

}  // namespace stepwire
