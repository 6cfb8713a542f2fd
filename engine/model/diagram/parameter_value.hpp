#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire::diagram {

/// Block that makes a parameter recordable as a signal.
struct ParameterValue {
  PerElement value = 0.0;
  Output<> y{};

  void outputs() { y = value; }

  static void declare(Declare<ParameterValue>& is);
};

}  // namespace stepwire::diagram
