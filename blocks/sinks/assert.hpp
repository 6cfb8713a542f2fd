#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Ends the run if its input is false (zero in any element).
struct Assert {
  Input<> u{};
  Diagnostic failed{};
  Time t{};

  void update() {
    for (Index k = 0; k < u.size(); ++k)
      if (u[k] == 0.0) failed.raise(t);
  }

  static void declare(Declare<Assert>& is);
};

}  // namespace stepwire
