#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// A value that grows steadily from one instant on: y = initial + slope max(0, t - start).
struct Ramp {
  PerElement slope = 1.0, start_ = 0.0, initial = 0.0;
  Output<> y{};
  Time t{};

  void outputs() { y = initial + slope * (static_cast<double>(t) - start_).max(0.0); }

  static void declare(Declare<Ramp>& is);
};

}  // namespace stepwire
