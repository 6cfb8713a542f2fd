#pragma once

#include <cstddef>
#include <vector>

#include "engine/view/geometry/curve.hpp"

namespace stepwire::geometry {

/// Number of curves through each of the equal cells over a part of the plane, row by row from the lowest.
struct Density {
  Extent x, y;
  std::size_t columns = 0, rows = 0;
  std::vector<double> counts;

  double cell_width() const { return x.width() / static_cast<double>(columns); }
  double cell_height() const { return y.width() / static_cast<double>(rows); }
};

/// Counts each curve, a line through its first two columns, once in each cell. The extents must have a width.
Density density_of(const std::vector<Curve>& curves, const Extent& x, const Extent& y, std::size_t columns,
                   std::size_t rows);

}  // namespace stepwire::geometry
