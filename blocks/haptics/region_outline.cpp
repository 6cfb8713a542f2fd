// Outline of a Region for figures.
#include <numbers>

#include "blocks/haptics/region.hpp"
#include "blocks/haptics/region/shape_reader.hpp"
#include "engine/base/math/elementary.hpp"
#include "engine/model/block/outline.hpp"

namespace stepwire {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Appends points along a piece, with the region on the left. An infinite piece is cut off at `reach`.
void append_points(const PlanePiece& piece, double reach, std::vector<Outline::Point>& points) {
  const double whole = std::isinf(piece.extent) ? reach : piece.length();
  const int steps = piece.is_line() ? 1 : static_cast<int>(std::ceil(piece.extent / (3.0 * degree)));
  for (int i = 0; i <= steps; ++i) {
    const double s = whole * (piece.side > 0.0 ? i : steps - i) / steps;
    const Vector2 point = piece.at(s);
    points.push_back({point.x, point.y, 0.0});
  }
}

/// Removes points that are indistinguishable from straight lines between their neighbours.
std::vector<Outline::Point> thinned(const std::vector<Outline::Point>& points, double least) {
  std::vector<Outline::Point> result;
  for (const Outline::Point& point : points) {
    const bool apart =
        result.empty() || fn::hypot(point[0] - result.back()[0], point[1] - result.back()[1]) >= least;
    if (apart || &point == &points.back()) result.push_back(point);
  }
  return result;
}

void outline_plane(const PlaneShape& shape, Outline& outline) {
  constexpr double digits = 1e10;  // ratio of size to fineness
  const double size = digits * fineness_of(shape);
  for (const PlaneShape& loop : loops_of(shape)) {
    Outline::Line line;
    for (const PlanePiece& piece : loop) {
      line.endless = line.endless || std::isinf(piece.extent);
      append_points(piece, 100.0 * size, line.points);
    }
    line.points = thinned(line.points, 1e-3 * size);
    // Where two corners of a boundary coincide, rounding leaves a loop of negligible size, which is omitted.
    constexpr std::size_t min_corners = 3;
    if (line.endless || line.points.size() >= min_corners) outline.lines.push_back(std::move(line));
  }
}

Vector3 normal_of(const Solid& solid) {
  return beside(solid.along);
}

Vector3 crossed(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Returns the circle about a point in the plane of two directions.
Outline::Line circle(Vector3 centre, double radius, Vector3 u, Vector3 v) {
  Outline::Line line;
  for (int angle = 0; angle <= 360; angle += 3) {
    const Vector3 point = centre + radius * (fn::cos(angle * degree) * u + fn::sin(angle * degree) * v);
    line.points.push_back({point.x, point.y, point.z});
  }
  return line;
}

/// Adds three perpendicular circles about both ends of the axis, and the lines between them.
void outline_solid(const Solid& solid, double radius, Outline& outline) {
  const Vector3 w = solid.along, u = normal_of(solid), v = crossed(w, u);
  const Vector3 last = solid.start + solid.length * w;
  for (const Vector3 centre : {solid.start, last}) {
    outline.lines.push_back(circle(centre, radius, u, v));
    outline.lines.push_back(circle(centre, radius, u, w));
    outline.lines.push_back(circle(centre, radius, v, w));
    if (!(solid.length > 0.0)) return;
  }
  for (const Vector3 side : {u, -1.0 * u, v, -1.0 * v}) {
    const Vector3 a = solid.start + radius * side, b = last + radius * side;
    outline.lines.push_back({{{a.x, a.y, a.z}, {b.x, b.y, b.z}}});
  }
}

}  // namespace

void Region::outline(Outline& outline) const {
  const ShapeReader reader([](const std::string& message, const Value&) { throw ShapeError(message); });
  const AnyShape read = reader.read(shape.value());
  if (const auto* plane = std::get_if<PlaneShape>(&read)) return outline_plane(*plane, outline);
  outline.space = true;
  for (const Solid& solid : std::get<SpaceShape>(read)) {
    outline_solid(solid, solid.radius, outline);
    if (solid.inner_radius > 0.0) outline_solid(solid, solid.inner_radius, outline);
  }
}

}  // namespace stepwire
