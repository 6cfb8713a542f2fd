#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stepwire::geometry {

/// Three indices of points, counterclockwise.
using Corners = std::array<std::size_t, 3>;

/// Returns the Delaunay triangles of points in the plane. Coordinates are rounded to 2^-30 of the extent of
/// the points; of points that then coincide, one is a corner.
std::vector<Corners> triangulate(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace stepwire::geometry
