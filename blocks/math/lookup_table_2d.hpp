#pragma once

#include "blocks/math/extrapolation.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Bilinear surface on a grid, for each element: y = f(row, column).
struct LookupTable2D {
  Numbers rows{0.0, 1.0}, columns{0.0, 1.0};
  Matrix values{2, 2, {0.0, 0.0, 0.0, 0.0}};
  Extrapolation extrapolation = Extrapolation::hold;
  Input<> row{}, column{};
  Output<> y{};

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) {
      const Bracket r = bracket(rows, row[k], extrapolation);
      const Bracket c = bracket(columns, column[k], extrapolation);
      y[k] = between(along_row(r.index, c), along_row(r.index + 1, c), r.share);
    }
  }

  double along_row(Index index, const Bracket& c) const {
    return between(values(index, c.index), values(index, c.index + 1), c.share);
  }

  void configure(Configure& is);
  static void declare(Declare<LookupTable2D>& is);
};

}  // namespace stepwire
