#include <fmt/format.h>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "blocks/haptics/region/plane_shape.hpp"

namespace stepwire {

namespace {

namespace geometry = boost::geometry;
using Corner = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<Corner, false>;  // counterclockwise

std::string fault_of(const Polygon& polygon) {
  // Checked first, since a polygon that crosses itself has no orientation.
  if (geometry::intersects(polygon))
    return "it crosses or touches itself; give its corners in their order along its edge";
  geometry::validity_failure_type failure = geometry::no_failure;
  if (geometry::is_valid(polygon, failure)) return "";
  if (failure == geometry::failure_spikes)
    return "one of its edges goes back on the one before; leave the corner between them out";
  return "it needs three corners that are not in one line";
}

}  // namespace

PlaneShape polygon(std::vector<Vector2> corners) {
  Polygon outline;
  for (const Vector2 corner : corners) geometry::append(outline.outer(), Corner(corner.x, corner.y));
  geometry::correct(outline);  // closes it and makes it counterclockwise
  const std::string fault = fault_of(outline);
  if (!fault.empty()) throw ShapeError(fault);
  PlaneShape shape;
  const auto& ring = outline.outer();
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const Vector2 a{ring[i].x(), ring[i].y()}, b{ring[i + 1].x(), ring[i + 1].y()};
    if (length(b - a) > 0.0) shape.push_back(line_between(a, b));
  }
  return shape;
}

}  // namespace stepwire
