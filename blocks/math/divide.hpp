#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Divides element by element: y = numerator / denominator.
struct Divide {
  Input<> numerator{}, denominator{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return numerator[i] / denominator[i]; });
  }

  static void declare(Declare<Divide>& is);
};

}  // namespace stepwire
