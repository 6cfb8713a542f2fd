#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Discards a signal.
struct Terminator {
  Input<> u{};

  static void declare(Declare<Terminator>& is);
};

}  // namespace stepwire
