#pragma once

#include <cstdint>

#include "engine/model/block/block.hpp"
#include "engine/model/block/configure.hpp"

namespace stepwire {

/// Matrix of another shape with the same numbers, column by column.
struct Reshape {
  std::int64_t rows = 1, columns = 1;
  Input<> u{};
  Output<> y{};

  void configure(Configure& is) {
    is.size("m", rows);
    is.size("n", columns);
    is.size("k", rows * columns);
  }
  void outputs() { y = u; }

  static void declare(Declare<Reshape>& is);
};

}  // namespace stepwire
