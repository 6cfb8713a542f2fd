#pragma once

#include <algorithm>
#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The way to a region from what is felt of a map with the second law of directionality, by which resistance
/// is F = F_max sin(angle between the push and that way), without saying to which side. At each tick in
/// motion
///
///     heading = direction of the push + s asin(F / F_max),
///
/// where the sense s (1: to the left, -1: to the right) is that of the last time, and the other one if F has
/// grown since. What does not stand out from the resistance of a free motion, F_free, counts as F = 0, and
/// then the way may lie anywhere within asin(F_free / F_max) to both sides.
struct ResistanceSearch {
  double weber = 0.0;
  Input<1> resistance{}, free{}, maximum{}, push{}, guess{}, moving{};
  Output<1> heading{}, precision{}, sense{};
  DiscreteState<1> felt{}, turning{};   ///< F and s of the last time; s is 0 before the first
  DiscreteState<1> found{}, certain{};  ///< heading and its precision as last told

  void outputs() {
    sense = looks() ? next_sense() : static_cast<double>(turning);
    heading = looks() ? push + sense * std::asin(share()) : static_cast<double>(found);
    precision = looks() ? precision_of(deviation()) : static_cast<double>(certain);
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
  bool stands_out() const { return resistance > (1.0 + weber) * free; }
  double share() const { return stands_out() ? std::clamp(resistance / maximum, 0.0, 1.0) : 0.0; }

  double next_sense() const {
    if (turning == 0.0) return std::sin(guess - push) < 0.0 ? -1.0 : 1.0;
    return resistance > felt ? -turning : static_cast<double>(turning);
  }

  /// Standard deviation of the heading, where F is felt with a constant share of itself as error. Near F_max,
  /// where the slope of asin has no end, and where the way may lie anywhere within an angle, that of an even
  /// distribution counts.
  double deviation() const {
    constexpr double root_of_three = 1.7320508075688772935, widest = 0.90689968211710892530;  // pi / sqrt(12)
    if (!stands_out()) return std::asin(std::clamp(free / maximum, 0.0, 1.0)) / root_of_three;
    const double error = weber * share(), slope = std::sqrt(1.0 - share() * share());
    return error < widest * slope ? error / slope : widest;
  }

  static double precision_of(double deviation) {
    constexpr double largest = 1e12;  // [1/rad^2], where nothing hides the way
    return deviation * deviation * largest > 1.0 ? 1.0 / (deviation * deviation) : largest;
  }
};

}  // namespace stepwire
