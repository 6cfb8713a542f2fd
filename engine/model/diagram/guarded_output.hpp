#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire::diagram {

/// Output of a part or block with `outputs: reset`, as other blocks read it. It passes the output through
/// while active, and has the value `off` otherwise.
struct GuardedOutput {
  PerElement off = 0.0;
  Input<> u{};
  Input<1> active{};
  Output<> y{};

  void outputs() {
    const bool is_active = active != 0.0;
    y.each([&](Index k) { return is_active ? u[k] : off[k]; });
  }

  static void declare(Declare<GuardedOutput>& is);
};

}  // namespace stepwire::diagram
