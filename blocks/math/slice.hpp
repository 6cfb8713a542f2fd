#pragma once

#include "engine/model/block/block.hpp"
#include "engine/model/block/configure.hpp"

namespace stepwire {

/// Selected rows and columns of a matrix.
struct Slice {
  Numbers rows{1.0}, columns{1.0};
  Input<> u{};
  Output<> y{};
  Index height = 0;

  void configure(Configure& is);
  void outputs() {
    for (Index column = 0; column < columns.size(); ++column)
      for (Index row = 0; row < rows.size(); ++row)
        y[column * rows.size() + row] =
            u[(static_cast<Index>(columns[column]) - 1) * height + static_cast<Index>(rows[row]) - 1];
  }

  static void declare(Declare<Slice>& is);
};

}  // namespace stepwire
