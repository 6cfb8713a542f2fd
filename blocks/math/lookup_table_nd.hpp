#pragma once

#include "blocks/math/extrapolation.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/tree.hpp"

namespace stepwire {

/// Table over a grid of several dimensions, multilinear between its points.
struct LookupTableND {
  static constexpr Index max_dimensions = 8;

  Tree points, values;
  Extrapolation extrapolation = Extrapolation::hold;
  Inputs u{};
  Output<> y{};

  Numbers grid{};   ///< Points of the first dimension, of the second, ...
  Numbers count{};  ///< Number of points of each dimension.
  Numbers table{};  ///< Values; the index of the last dimension varies fastest.

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) y[k] = value_at(k);
  }

  void configure(Configure& is);
  static void declare(Declare<LookupTableND>& is);

 private:
  /// Interpolates along one dimension after the other, from the corners of the cell.
  double value_at(Index k) const {
    Bracket at[max_dimensions];
    Index stride[max_dimensions];
    find_cell(k, at, stride);
    const Index n = count.size();
    double corner[Index{1} << max_dimensions];
    for (Index c = 0; c < Index{1} << n; ++c) {
      Index place = 0;
      for (Index d = 0; d < n; ++d) place += (at[d].index + (c >> d & 1)) * stride[d];
      corner[c] = table[place];
    }
    for (Index d = 0; d < n; ++d)
      for (Index c = 0; c < Index{1} << (n - d - 1); ++c)
        corner[c] = between(corner[2 * c], corner[2 * c + 1], at[d].share);
    return corner[0];
  }

  void find_cell(Index k, Bracket* at, Index* stride) const {
    Index first = 0, step = 1;
    for (Index d = 0; d < count.size(); ++d) {
      const auto size = static_cast<Index>(count[d]);
      at[d] = bracket(Numbers::view(grid.data() + first, size), u[d][k], extrapolation);
      first += size;
    }
    for (Index d = count.size() - 1; d >= 0; --d) {
      stride[d] = step;
      step *= static_cast<Index>(count[d]);
    }
  }
};

}  // namespace stepwire
