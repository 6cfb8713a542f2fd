#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Takes a signal and does nothing with it.
struct Terminator {
  Input<> u{};

  static void declare(Declare<Terminator>& is);
};

}  // namespace stepwire
