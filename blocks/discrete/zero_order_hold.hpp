#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Samples its input at its own period and holds it in between.
struct ZeroOrderHold {
  Input<> u{};
  Output<> y{};

  void outputs() { y = u; }

  static void declare(Declare<ZeroOrderHold>& is);
};

}  // namespace stepwire
