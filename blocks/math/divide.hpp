#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Divides element by element: y = numerator / denominator.
struct Divide {
  Input<> numerator{}, denominator{};
  Output<> y{};

  void outputs() { y = numerator / denominator; }

  static void declare(Declare<Divide>& is);
};

}  // namespace stepwire
