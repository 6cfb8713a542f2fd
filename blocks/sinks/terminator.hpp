#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Takes a signal and does nothing with it.
struct Terminator {
  Input<> u{};

  static void declare(Declare<Terminator>& is);
};

}  // namespace stepwire
