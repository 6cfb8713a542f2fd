#pragma once

#include <algorithm>
#include <cmath>

#include "engine/block/block.hpp"

namespace stepwire {

/// The way to a region from what is felt of a map with the second law of directionality, by which resistance
/// is F = F_max sin(angle off that way), without saying to which side. At each tick in motion
///
///     heading = direction of the motion + s asin(F / F_max),
///
/// where the sense s (1: to the left, -1: to the right) is that of the last time, and the other one if F has
/// grown since.
struct ResistanceSearch {
  double weber = 0.0, threshold = 0.0;
  Input<1> resistance{}, maximum{}, motion{}, guess{}, moving{};
  Output<1> heading{}, precision{}, sense{};
  DiscreteState<1> felt{}, turning{};   ///< F and s of the last time; s is 0 before the first
  DiscreteState<1> found{}, certain{};  ///< heading and its precision as last told

  void outputs() {
    sense = looks() ? next_sense() : static_cast<double>(turning);
    heading = looks() ? motion + sense * std::asin(share()) : static_cast<double>(found);
    precision = looks() ? precision_of(share()) : static_cast<double>(certain);
  }

  void update() {
    if (looks()) felt = resistance;
    turning = sense;
    found = heading;
    certain = precision;
  }

  static void declare(Declare<ResistanceSearch>& is);

 private:
  bool looks() const { return moving != 0.0 && maximum > 0.0; }
  double share() const { return std::clamp(resistance / maximum, 0.0, 1.0); }

  double next_sense() const {
    if (turning == 0.0) return std::sin(guess - motion) < 0.0 ? -1.0 : 1.0;
    return resistance > felt ? -turning : static_cast<double>(turning);
  }

  /// One over the variance of asin(F / F_max), where F is felt with a constant share of itself and no better
  /// than the threshold; near F_max, where its slope has no end, that of a guess within half a turn.
  double precision_of(double ratio) const {
    constexpr double widest = 0.90689968211710892530;  // pi / sqrt(12)
    const double error = std::hypot(weber * ratio, threshold / maximum);
    const double slope = std::sqrt(1.0 - ratio * ratio);
    const double deviation = error < widest * slope ? error / slope : widest;
    return deviation > 0.0 ? 1.0 / (deviation * deviation) : largest;
  }

  static constexpr double largest = 1e12;  ///< precision of what is felt without any error [1/rad^2]
};

}  // namespace stepwire
