#pragma once

#include <stepwire/block.hpp>

#include "yard/law.hpp"

namespace yard {

/// Drag of a flow: F = -c v |v|.
struct Drag {
  double c = 1.0;
  stepwire::Input<1> v{};
  stepwire::Output<1> F{};

  void outputs() { F = drag_force(c, v); }

  static void declare(stepwire::Declare<Drag>& is);
};

}  // namespace yard
