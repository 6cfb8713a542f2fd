#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Output 1 after no element of u has changed by more than its tolerance for longer than `time`, during which
/// `moving` was true.
struct StuckDetector {
  double time = 0.1;
  PerElement tolerance = 0.0;
  Input<> u{};
  Input<1> moving{};
  Output<1> y{};
  DiscreteState<> held{};
  DiscreteState<1> still{};
  Period period{};

  void outputs() { y = rests() && still > time * (1.0 + 1e-9) ? 1.0 : 0.0; }
  void update() {
    if (rests()) {
      still = still + period;
    } else {
      still = moving > 0.0 ? static_cast<double>(period) : 0.0;
      held = u;
    }
  }

  static void declare(Declare<StuckDetector>& is);

 private:
  /// True if the input is at rest although it should move.
  bool rests() const {
    if (!(moving > 0.0)) return false;
    for (Index i = 0; i < u.size(); ++i)
      if (std::abs(u[i] - held[i]) > tolerance[i]) return false;
    return true;
  }
};

}  // namespace stepwire
