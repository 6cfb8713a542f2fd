#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/view/geometry/curve.hpp"

namespace stepwire::geometry {

/// Three indices of points, counterclockwise.
using Corners = std::array<std::size_t, 3>;

/// Returns the Delaunay triangles of points in the plane. Coordinates are rounded to 2^-30 of the extent of
/// the points; of points that then coincide, one is a corner.
std::vector<Corners> triangulate(const std::vector<double>& x, const std::vector<double>& y);

/// Values at the centres of equal cells, row by row from the lowest y; NaN where unknown.
struct Grid {
  double x = 0.0, y = 0.0;    ///< centre of the first cell
  double dx = 1.0, dy = 1.0;  ///< size of a cell
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;

  double& at(std::size_t column, std::size_t row) { return values[row * columns + column]; }
  double at(std::size_t column, std::size_t row) const { return values[row * columns + column]; }
};

/// Converts points (x, y, value) into a grid.
///
/// Points on a lattice keep its cells. Other points are averaged in `cells` cells along each side. Between
/// points that are at most `gap` apart the value is linear over their Delaunay triangles. Cells outside of
/// the measured points are NaN.
Grid make_grid(const Curve& points, std::size_t cells, double gap);

/// Returns the grid in a window of the plane whose edges are cell edges; the grid itself if it does not reach
/// beyond the window.
Grid within(const Grid& grid, const Extent& across, const Extent& up);

/// Returns the contour lines of the grid, linear between centres, at this value.
std::vector<Curve> contour(const Grid& grid, double level);

}  // namespace stepwire::geometry
