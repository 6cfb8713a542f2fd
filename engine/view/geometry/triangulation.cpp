#include "engine/view/geometry/triangulation.hpp"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>

#include "engine/view/geometry/extent.hpp"

namespace stepwire::geometry {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using IntegerPoint = boost::polygon::point_data<std::int32_t>;

/// Scales coordinates to integers, for which the predicates of the library are exact.
std::vector<IntegerPoint> scaled(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr double most = 1 << 30;
  const Extent across = extent_of(x), up = extent_of(y);
  const double scale = most / std::max({across.width(), up.width(), 1e-300});
  const auto whole = [&](double value, double low) {
    return static_cast<std::int32_t>(std::lround((value - low) * scale));
  };
  std::vector<IntegerPoint> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    points.emplace_back(whole(x[i], across.low), whole(y[i], up.low));
  return points;
}

/// Returns the points whose cells meet at a vertex of the diagram, counterclockwise: three, or more on one
/// circle.
std::vector<std::size_t> points_around(const Diagram::vertex_type& corner) {
  std::vector<std::size_t> points;
  const auto* edge = corner.incident_edge();
  do {
    points.push_back(edge->cell()->source_index());
    edge = edge->rot_next();
  } while (edge != corner.incident_edge());
  return points;
}

}  // namespace

std::vector<Corners> triangulate(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 3) return {};
  const std::vector<IntegerPoint> points = scaled(x, y);
  Diagram cells;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &cells);
  std::vector<Corners> triangles;
  for (const auto& corner : cells.vertices()) {
    const std::vector<std::size_t> around = points_around(corner);
    for (std::size_t i = 2; i < around.size(); ++i)
      triangles.push_back({around[0], around[i - 1], around[i]});
  }
  return triangles;
}

}  // namespace stepwire::geometry
