#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stepwire {

/// Three indices of points, counterclockwise.
using Corners = std::array<std::size_t, 3>;

/// The Delaunay triangles of points in the plane, which are the least slender ones. Points that are the same,
/// and few that are nearly in line with others at the rim, may be left out.
std::vector<Corners> triangulate(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace stepwire
