// Texts of lengths and points of a shape.
#include <fmt/format.h>

#include <cmath>

#include "blocks/haptics/region/shape_reader.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire {

double quantity_in(const std::string& text, const std::string& unit) {
  if (const auto quantity = unit::parse_quantity(text)) {
    const bool fits = !quantity->dimension || *quantity->dimension == unit::parse_unit(unit)->dimension;
    return fits ? quantity->value : std::nan("");
  }
  try {
    return expression::Expression(text, [](std::string_view) { return false; })({});
  } catch (const expression::ExpressionError&) {
    return std::nan("");
  }
}

void ShapeReader::refuse(const std::string& message, const Value& where) const {
  refuse_(message, where);
  throw ShapeError(message);
}

const Value& ShapeReader::need(const Value& tree, const std::string& key, const std::string& example) const {
  if (const Value* value = tree.find(key)) return *value;
  refuse(fmt::format("'{}' is missing, as in {}", key, example), tree);
}

double ShapeReader::read_length(const Value& tree, const std::string& what) const {
  const double number = tree.text() ? quantity_in(*tree.text(), "m") : std::nan("");
  if (!std::isfinite(number))
    refuse(fmt::format("{}: {} is no length; write it as 8 mm", what,
                       tree.text() ? "'" + *tree.text() + "'" : "what stands here"),
           tree);
  return number;
}

double ShapeReader::read_positive(const Value& tree, const std::string& what) const {
  const double number = read_length(tree, what);
  if (!(number > 0.0))
    refuse(fmt::format("{}: {} leaves nothing; it must be above 0", what, shown(number)), tree);
  return number;
}

std::vector<double> ShapeReader::read_lengths(const Value& tree, const std::string& what) const {
  if (!tree.list()) refuse(fmt::format("{} must be a list of lengths, as [0 mm, 180 mm]", what), tree);
  std::vector<double> numbers;
  for (const Value& item : *tree.list()) numbers.push_back(read_length(item, what));
  return numbers;
}

std::vector<std::vector<double>> ShapeReader::read_points(const Value& tree, std::size_t least) const {
  if (!tree.list() || tree.list()->size() < least)
    refuse(fmt::format("it must be a list of {} points or more, as [[0 mm, 180 mm], [5 mm, 200 mm]]", least),
           tree);
  std::vector<std::vector<double>> points;
  for (const Value& item : *tree.list()) {
    points.push_back(read_lengths(item, "a point"));
    const std::size_t size = points.back().size();
    if (size != points.front().size() || size < 2 || size > 3)
      refuse(
          fmt::format("a point has 2 coordinates, in space 3, and all have as many; this one has {}", size),
          item);
  }
  return points;
}

std::vector<Vector2> ShapeReader::read_plane_points(const Value& tree, std::size_t least) const {
  std::vector<Vector2> points;
  for (const auto& point : read_points(tree, least)) {
    if (point.size() != 2) refuse("points of this shape have 2 coordinates: it lies in the plane", tree);
    points.push_back({point[0], point[1]});
  }
  return points;
}

bool ShapeReader::read_closed(const Value& tree) const {
  const Value* closed = tree.find("closed");
  if (!closed) return false;
  if (!closed->text() || (*closed->text() != "true" && *closed->text() != "false"))
    refuse("'closed' must be true or false", *closed);
  return *closed->text() == "true";
}

}  // namespace stepwire
