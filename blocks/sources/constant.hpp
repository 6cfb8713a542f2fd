#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Constant value: y = value.
struct Constant {
  PerElement value = 1.0;
  Output<> y{};

  void outputs() { y = value; }

  static void declare(Declare<Constant>& is);
};

}  // namespace stepwire
