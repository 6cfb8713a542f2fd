#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Reduces the resistance along a path. The path leads from where the pin left the region, or started
/// outside, to the nearest point of its boundary:
///
///     error = min(distance, (1 - easing) distance + steepness beside)
///
/// Here `beside` is the distance of the pin from the path minus its half width.
struct GuidePath {
  enum class Renewal { none, every_sample };

  Renewal renewal = Renewal::every_sample;
  double half_width = 1e-3, steepness = 5.0, easing = 1.0;
  double trail = 3e-3;
  Input<> position{}, nearest{};
  Input<1> distance{};
  Output<1> error{}, beside{};
  Output<> start{}, target{};
  DiscreteState<> from{}, to{};  // ends of the path
  DiscreteState<1> laid{};       // 1 while there is a path

  void outputs() {
    const bool kept = laid != 0.0;
    start.each([&](Index i) { return kept ? from[i] : position[i]; });
    target.each([&](Index i) { return kept && renewal == Renewal::none ? to[i] : nearest[i]; });
    beside = std::max(0.0, distance_from_path() - half_width);
    const double outside = std::max(0.0, static_cast<double>(distance));
    error = std::min(outside, (1.0 - easing) * outside + steepness * beside);
  }

  void update() {
    const bool outside = distance > 0.0;
    if (!outside || laid == 0.0) {
      from = position;
      to = nearest;
    }
    laid = outside ? 1.0 : 0.0;
    if (renewal == Renewal::every_sample) follow();
  }

  void configure(Configure& is);
  static void declare(Declare<GuidePath>& is);

 private:
  double distance_from_path() const {
    SumOfSquares ways;
    for (Index i = 0; i < position.size(); ++i) ways.add(target[i] - start[i]);
    const double square = ways.scaled(), scale = ways.scale();
    double along = 0.0;
    for (Index i = 0; i < position.size(); ++i)
      along += scale * (target[i] - start[i]) * (scale * (position[i] - start[i]));
    const double share = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    return length_of(position.size(),
                     [&](Index i) { return position[i] - start[i] - share * (target[i] - start[i]); });
  }

  /// Moves the start: it stays until the pin is farther away than the trail, and then is dragged along at
  /// that distance.
  void follow() {
    SumOfSquares squares;
    for (Index i = 0; i < position.size(); ++i) squares.add(position[i] - from[i]);
    const double scaled_trail = squares.scale() * trail;
    if (squares.scaled() <= scaled_trail * scaled_trail) return;
    const double share = trail / squares.root();
    from.each([&](Index i) { return position[i] - share * (position[i] - from[i]); });
  }
};

}  // namespace stepwire
