#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Moves a map so that the pin is in its authorized region: shifted = position - origin.
struct ReOrigin {
  double margin = 0.0;
  Input<> position{}, nearest{}, direction{};
  Input<1> distance{}, trigger{};
  Output<> shifted{}, origin{};
  DiscreteState<> moved{};
  DiscreteState<1> before{};  // trigger at the last tick

  void outputs() {
    shifted.each([&](Index i) { return position[i] - moved[i]; });
    origin = moved;
  }

  void update() {
    const bool wanted = trigger.connected() ? trigger != 0.0 : true;
    if (wanted && before == 0.0 && distance > -margin)
      moved.each([&](Index i) { return position[i] - nearest[i] + margin * direction[i]; });
    before = wanted ? 1.0 : 0.0;
  }

  static void declare(Declare<ReOrigin>& is);
};

}  // namespace stepwire
