#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Each element times a number: y = gain u.
struct Gain {
  PerElement gain = 1.0;
  Input<> u{};
  Output<> y{};

  void outputs() { y = gain * u; }

  static void declare(Declare<Gain>& is);
};

}  // namespace stepwire
