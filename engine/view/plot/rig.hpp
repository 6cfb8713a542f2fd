#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire::plot {

/// One to three coordinates [m]: numbers of the diagram, or formulas of recordings.
using RigPoint = std::vector<std::variant<double, query::Formula>>;

/// Kind of element, and its number of points.
struct RigKind {
  std::string name;
  std::string doc;
  std::size_t min_points = 2, max_points = 2;
  bool directed = false;  ///< true for a kind with a direction
};

/// Element of a mechanism.
struct RigElement {
  std::string kind, name;
  std::vector<RigPoint> points;
  std::optional<double> body;  ///< Length of the housing of a link [m].
  double offset = 0.0;  ///< Offset of a dimension, left of the line from its first point to its second [m].
  std::vector<double> direction{};  ///< Components of the direction of a force; empty: by its kind.
};

/// Mechanism of a figure.
struct Rig {
  std::string title;
  std::vector<std::string> axes{"x", "y", "z"};  ///< their names
  bool z_up = false;                             ///< true if z is vertical, else y
  bool schematic = false;                        ///< true without axes and scale
  std::map<std::string, RigPoint> points;        ///< points with names
  std::vector<RigElement> elements;
  std::optional<query::Formula> where;  ///< selects the drawn row, the first for which it is true
  std::size_t recording = 0;
  yaml::Mark mark;
};

/// Returns the keys of a figure of a rig.
const yaml::Key& rig_form();

/// Returns a mechanism in the format of rig.mjs. `points` returns the points of an element, with `dimensions`
/// coordinates each, as a list.
json::Json rig_json(
    const Rig& rig,
    const std::function<json::Json(const RigElement& element, std::size_t dimensions)>& points);

/// Reads a rig; collects faults.
Rig read_rig(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

}  // namespace stepwire::plot
