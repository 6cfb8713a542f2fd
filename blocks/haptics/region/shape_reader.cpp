// More than 300 lines with its header: the keys and checks of all kinds of shapes.
#include "blocks/haptics/region/shape_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace stepwire {

namespace {

/// Largest distance between a curve and the arcs that approximate it [m].
constexpr double fit_tolerance = 4e-10;

/// Kind of shape, identified by the first of its keys.
struct ShapeKind {
  std::vector<std::string> keys;
  std::string example;
};

const std::vector<ShapeKind>& kinds() {
  static const std::vector<ShapeKind> all{
      {{"radius", "center", "inner_radius"}, "{center: [0 mm, 200 mm], radius: 8 mm}"},
      {{"polygon"}, "{polygon: [[0 mm, 0 mm], [9 mm, 0 mm], [0 mm, 9 mm]]}"},
      {{"corridor", "half_width", "closed"}, "{corridor: [[0 mm, 0 mm], [9 mm, 5 mm]], half_width: 1 mm}"},
      {{"spline", "half_width", "closed"}, "{spline: [[0 mm, 0 mm], [9 mm, 5 mm]], half_width: 1 mm}"},
      {{"left", "right", "y"}, "{left: -8 mm, right: \"8 mm + 0.1*y\", y: [180 mm, 220 mm]}"},
      {{"right", "left", "y"}, "{right: \"8 mm + 0.1*y\", y: [180 mm, 220 mm]}"},
      {{"union"}, "{union: [SHAPE, SHAPE]}"}};
  return all;
}

std::string all_examples() {
  std::string text;
  for (const ShapeKind& kind : kinds())
    if (kind.keys.front() != "right") text += (text.empty() ? "" : ", ") + kind.example;
  return text;
}

bool is_among(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

AnyShape ShapeReader::read(const Value& tree) const {
  if (!tree.map()) refuse("it must be a map, one of " + all_examples(), tree);
  for (const ShapeKind& kind : kinds()) {
    if (!tree.find(kind.keys.front())) continue;
    for (const auto& [key, value] : *tree.map())
      if (!is_among(kind.keys, key))
        refuse(fmt::format("a shape with '{}' has no '{}'; it is {}", kind.keys.front(), key, kind.example),
               value);
    try {
      return read_kind(kind.keys.front(), tree);
    } catch (const ShapeError& error) {
      refuse(error.what(), tree);
    }
  }
  refuse("no shape is told by these keys; it is one of " + all_examples(), tree);
}

AnyShape ShapeReader::read_kind(const std::string& kind, const Value& tree) const {
  if (kind == "radius") return read_circle(tree);
  if (kind == "polygon") return read_polygon(tree);
  if (kind == "corridor" || kind == "spline") return read_corridor(kind, tree);
  if (kind == "union") return read_union(tree);
  return read_band(tree);
}

AnyShape ShapeReader::read_circle(const Value& tree) const {
  const double radius = read_positive(*tree.find("radius"), "radius");
  const Value* inner = tree.find("inner_radius");
  const double inner_radius = inner ? read_length(*inner, "inner_radius") : 0.0;
  if (inner_radius < 0.0 || inner_radius >= radius)
    refuse(fmt::format("inner_radius: {} leaves nothing; it must be from 0 to below the radius of {}",
                       shown(inner_radius), shown(radius)),
           *inner);
  const Value& where = need(tree, "center", "{center: [0 mm, 200 mm], radius: 8 mm}");
  const std::vector<double> center = read_lengths(where, "center");
  if (center.size() == 2) return disk({center[0], center[1]}, radius, inner_radius);
  if (center.size() != 3) refuse("center: it has 2 coordinates for a circle and 3 for a sphere", where);
  return SpaceShape{ball({center[0], center[1], center[2]}, radius, inner_radius)};
}

AnyShape ShapeReader::read_polygon(const Value& tree) const {
  return polygon(read_plane_points(*tree.find("polygon"), 3));
}

AnyShape ShapeReader::read_corridor(const std::string& key, const Value& tree) const {
  const Value& list = *tree.find(key);
  const double half_width = read_positive(
      need(tree, "half_width", "{corridor: [[0 mm, 0 mm], [9 mm, 5 mm]], half_width: 1 mm}"), "half_width");
  const bool closed = read_closed(tree);
  const auto points = read_points(list, closed ? 3 : 2);
  if (points.front().size() == 3) {
    if (points.size() > 2 || closed) refuse("in space a corridor is straight: give it two points", list);
    const auto &a = points.front(), &b = points.back();
    return SpaceShape{corridor(Vector3{a[0], a[1], a[2]}, Vector3{b[0], b[1], b[2]}, half_width)};
  }
  const auto plane = read_plane_points(list, 2);
  return corridor(
      key == "spline" ? spline_through(plane, closed, fit_tolerance) : chain_through(plane, closed),
      half_width);
}

AnyShape ShapeReader::read_union(const Value& tree) const {
  const Value& list = *tree.find("union");
  if (!list.list() || list.list()->empty()) refuse("a union is a list of shapes", list);
  std::vector<PlaneShape> plane;
  SpaceShape space;
  for (const Value& item : *list.list()) {
    const AnyShape shape = read(item);
    if (const auto* flat = std::get_if<PlaneShape>(&shape)) plane.push_back(*flat);
    if (const auto* solids = std::get_if<SpaceShape>(&shape))
      space.insert(space.end(), solids->begin(), solids->end());
    if (!plane.empty() && !space.empty())
      refuse("this shape and one before it are not both in the plane or both in space", item);
  }
  refuse_contact(space);
  if (space.empty()) return united(plane);
  return space;
}

AnyShape ShapeReader::read_band(const Value& tree) const {
  const std::string example = "{left: -8 mm, right: \"8 mm + 0.1*y\", y: [180 mm, 220 mm]}";
  const Value& range = need(tree, "y", example);
  const auto ends = read_lengths(range, "y");
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    refuse("y must be two lengths, the lower one first, as [180 mm, 220 mm]", range);
  std::optional<BandSide> left, right;
  if (const Value* side = tree.find("left")) left = read_side(*side, ends[0], ends[1]);
  if (const Value* side = tree.find("right")) right = read_side(*side, ends[0], ends[1]);
  return band(left ? &*left : nullptr, right ? &*right : nullptr, ends[0], ends[1]);
}

BandSide ShapeReader::read_side(const Value& tree, double low, double high) const {
  try {
    return tree.list() ? side_of_points(tree, low, high) : side_of_formula(tree, low, high);
  } catch (const ShapeError& error) {
    refuse(error.what(), tree);
  }
}

BandSide ShapeReader::side_of_points(const Value& tree, double low, double high) const {
  const std::vector<Vector2> points = read_plane_points(tree, 2);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (!(points[i].y < points[i + 1].y))
      refuse(fmt::format("y must grow from point to point, but {} follows on {}", shown(points[i + 1]),
                         shown(points[i])),
             tree);
  if (points.front().y > low || points.back().y < high)
    refuse(fmt::format("the points go from y = {} to {}, but the region from {} to {}",
                       shown(points.front().y), shown(points.back().y), shown(low), shown(high)),
           tree);
  const auto x = [points](double y) {
    auto next = std::upper_bound(points.begin() + 1, points.end() - 1, y,
                                 [](double height, Vector2 point) { return height < point.y; });
    const Vector2 a = *(next - 1), b = *next;
    return a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
  };
  std::vector<Vector2> inside{{x(low), low}};
  for (const Vector2 point : points)
    if (point.y > low && point.y < high) inside.push_back(point);
  inside.push_back({x(high), high});
  return {chain_through(inside, false), x};
}

BandSide ShapeReader::side_of_formula(const Value& tree, double low, double high) const {
  if (!tree.text()) refuse("a boundary is a formula of y, as \"8 mm + 0.1*y\", or a list of points", tree);
  try {
    const expression::Expression formula(*tree.text(), [](std::string_view name) { return name == "y"; });
    const auto x = [formula](double y) {
      return formula(std::span<const double>(&y, formula.variables().size()));
    };
    return {chain_along([&](double y) { return Vector2{x(y), y}; }, low, high, fit_tolerance), x};
  } catch (const expression::ExpressionError& error) {
    refuse(
        fmt::format("'{}', character {}: {}; it may use y", *tree.text(), error.position + 1, error.what()),
        tree);
  }
}

}  // namespace stepwire
