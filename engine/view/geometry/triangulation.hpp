#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stepwire::geometry {

/// Three indices of points, counterclockwise.
using Corners = std::array<std::size_t, 3>;

/// The Delaunay triangles of points in the plane, which are the least slender ones. Coordinates are rounded
/// to 2^-30 of the extent of the points; of points that are then the same, one is a corner.
std::vector<Corners> triangulate(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace stepwire::geometry
