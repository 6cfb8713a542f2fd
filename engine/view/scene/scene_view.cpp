#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/view/scene/scene.hpp"

namespace stepwire::scene {
namespace {

using Point = std::array<double, 2>;

/// Default sizes as shares of the shorter side of the view.
constexpr double ball_share = 0.025, point_share = 0.014, line_share = 0.008, wall_share = 0.022,
                 text_share = 0.045;

double distance_from_piece(Point at, Point from, Point to) {
  const double dx = to[0] - from[0], dy = to[1] - from[1], square = dx * dx + dy * dy;
  const double along = square > 0.0 ? ((at[0] - from[0]) * dx + (at[1] - from[1]) * dy) / square : 0.0;
  const double share = std::clamp(along, 0.0, 1.0);
  return std::hypot(at[0] - from[0] - share * dx, at[1] - from[1] - share * dy);
}

double distance_from(const SceneWall& wall, Point at) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < wall.points.size(); ++i)
    least = std::min(least, distance_from_piece(at, wall.points[i - 1], wall.points[i]));
  if (wall.closed) least = std::min(least, distance_from_piece(at, wall.points.back(), wall.points.front()));
  return least;
}

/// Computes the shapes of one instant from the values of all formulas.
class Shaper {
 public:
  Shaper(const Scene& scene, std::vector<double> values)
      : scene_(scene),
        values_(std::move(values)),
        side_(std::min(scene.x[1] - scene.x[0], scene.y[1] - scene.y[0])) {}

  std::vector<SceneShape> shapes() const {
    std::vector<SceneShape> shapes;
    for (const SceneObject& object : scene_.objects)
      if (object.kind->name == "walls")
        append_walls(object, shapes);
      else
        shapes.push_back(shape_of(object));
    return shapes;
  }

 private:
  bool holds(FormulaIndex formula) const { return values_[formula] != 0.0 && !std::isnan(values_[formula]); }
  Point point(const std::array<FormulaIndex, 2>& at) const { return {values_[at[0]], values_[at[1]]}; }
  double number(const std::optional<FormulaIndex>& formula, double share) const {
    return formula ? values_[*formula] : share * side_;
  }

  SceneColor color_of(const SceneObject& object) const {
    for (const ColorRule& rule : object.colors)
      if (!rule.when || holds(*rule.when)) return rule.color;
    return object.colors.back().color;
  }

  double size_of(const SceneObject& object) const {
    const std::string& kind = object.kind->name;
    if (kind == "text") return number(object.size, text_share);
    return number(object.radius, kind == "point" ? point_share : ball_share);
  }

  SceneShape shape_of(const SceneObject& object) const {
    SceneShape shape;
    shape.object = &object;
    for (const auto& at : object.points) shape.points.push_back(point(at));
    shape.size = size_of(object);
    shape.width = number(object.width, object.kind->name == "walls" ? wall_share : line_share);
    shape.color = color_of(object);
    bool finite = std::isfinite(shape.size) && std::isfinite(shape.width);
    for (const Point& at : shape.points) finite = finite && std::isfinite(at[0]) && std::isfinite(at[1]);
    shape.shown = finite && (!object.when || holds(*object.when));
    if (!finite) std::ranges::fill(shape.points, Point{});
    if (!std::isfinite(shape.size)) shape.size = 0.0;
    if (!std::isfinite(shape.width)) shape.width = 0.0;
    return shape;
  }

  /// Returns the index of the crossed wall; the number of walls if none is crossed.
  std::size_t crossed_wall(const SceneObject& object) const {
    if (!object.distance || !(values_[*object.distance] > 0.0)) return object.walls.size();
    if (!object.nearest) return 0;
    std::vector<double> distances;
    for (const SceneWall& wall : object.walls)
      distances.push_back(distance_from(wall, point(*object.nearest)));
    return static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
  }

  void append_walls(const SceneObject& object, std::vector<SceneShape>& shapes) const {
    const std::size_t crossed = crossed_wall(object);
    SceneShape shape = shape_of(object);
    const SceneColor color = shape.color;
    for (std::size_t i = 0; i < object.walls.size(); ++i) {
      shape.wall = i;
      shape.crossed = i == crossed;
      shape.color = shape.crossed && object.crossed ? *object.crossed : color;
      shapes.push_back(shape);
    }
  }

  const Scene& scene_;
  std::vector<double> values_;
  double side_;
};

}  // namespace

SceneView::SceneView(const Scene& scene, const std::vector<std::string>& columns) : scene_(scene) {
  for (const query::Formula& formula : scene.formulas) {
    std::vector<std::size_t>& places = places_.emplace_back();
    for (const std::string& name : formula.columns) {
      const auto found = std::ranges::find(columns, name);
      if (found == columns.end()) throw std::invalid_argument(fmt::format("'{}' was not recorded", name));
      places.push_back(static_cast<std::size_t>(found - columns.begin()));
    }
  }
}

std::vector<SceneShape> SceneView::shapes(std::span<const double> row) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < places_.size(); ++i)
    values.push_back(scene_.formulas[i].expression(row.data(), places_[i]));
  return Shaper(scene_, std::move(values)).shapes();
}

std::vector<double> row_of(const record::Recording& recording, std::size_t row) {
  std::vector<double> values;
  for (const table::Column& column : recording.table.columns) values.push_back(column.values[row]);
  return values;
}

SceneView view_of(const Scene& scene, const record::Recording& recording) {
  std::vector<std::string> columns;
  for (const table::Column& column : recording.table.columns) columns.push_back(column.name);
  return {scene, columns};
}

}  // namespace stepwire::scene
