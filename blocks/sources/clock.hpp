#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The time of the run: y = t.
struct Clock {
  Output<1> y{};
  Time t{};

  void outputs() { y = t; }

  static void declare(Declare<Clock>& is);
};

}  // namespace stepwire
