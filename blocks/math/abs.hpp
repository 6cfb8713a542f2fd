#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// The size of each element: y = |u|.
struct Abs {
  Input<> u{};
  Output<> y{};

  void outputs() { y = u.abs(); }

  static void declare(Declare<Abs>& is);
};

}  // namespace stepwire
