#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// The angle of a direction: y = atan2(opposite, adjacent) in (-pi, pi].
struct Atan2 {
  Input<> opposite{}, adjacent{};
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return fn::atan2(opposite[k], adjacent[k]); });
  }

  static void declare(Declare<Atan2>& is);
};

}  // namespace stepwire
