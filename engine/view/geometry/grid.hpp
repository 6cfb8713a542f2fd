#pragma once

#include <cstddef>
#include <vector>

#include "engine/view/geometry/curve.hpp"
#include "engine/view/geometry/extent.hpp"

namespace stepwire::geometry {

/// Values at the centres of equal cells, row by row from the lowest y; nan where nothing is known.
struct Grid {
  double x = 0.0, y = 0.0;    ///< centre of the first cell
  double dx = 1.0, dy = 1.0;  ///< width and height of a cell
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;

  double& at(std::size_t column, std::size_t row) { return values[row * columns + column]; }
  double at(std::size_t column, std::size_t row) const { return values[row * columns + column]; }
};

/// Points (x, y, value) as a grid. Points that lie on a lattice keep its cells; others are averaged in
/// `cells` cells along each side, and between points that are no farther than `gap` apart the value is linear
/// over their Delaunay triangles. What lies outside of the measured points stays nan.
Grid make_grid(const Curve& points, std::size_t cells, double gap);

/// The grid in a window of the plane, whose edges are those of cells; itself where it does not reach beyond.
Grid within(const Grid& grid, const Extent& across, const Extent& up);

/// Curves along which the grid, linear between centres, has this value.
std::vector<Curve> contour(const Grid& grid, double level);

}  // namespace stepwire::geometry
