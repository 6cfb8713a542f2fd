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

/// One to three coordinates [m]: numbers that the diagram has, or formulas of what was recorded.
using RigPoint = std::vector<std::variant<double, query::Formula>>;

/// A kind of element, and how many points it takes.
struct RigKind {
  std::string name;
  std::string doc;
  std::size_t min_points = 2, max_points = 2;
  bool directed = false;  ///< it has a direction of its own
};

/// All kinds of elements; mechanism.mjs draws them.
const std::vector<RigKind>& rig_kinds();

/// A piece of a mechanism.
struct RigElement {
  std::string kind, name;
  std::vector<RigPoint> points;
  std::optional<double> body;  ///< how long the housing of a link is [m]
  double offset = 0.0;  ///< of a dimension, to the left of the way from its first point to its second [m]
  std::vector<double> direction{};  ///< of a force and alike, along the axes; empty: as its kind has it
};

/// A mechanism as a figure describes it.
struct Rig {
  std::string title;
  std::vector<std::string> axes{"x", "y", "z"};  ///< their names
  bool z_up = false;                             ///< z is drawn upwards, else y
  bool schematic = false;                        ///< without axes and scale
  std::map<std::string, RigPoint> points;        ///< that have names
  std::vector<RigElement> elements;
  std::optional<query::Formula> where;  ///< the first row for which this is true is drawn
  std::size_t recording = 0;
  yaml::Mark mark;
};

/// The keys of a figure that a rig has.
const yaml::Key& rig_form();

/// A mechanism as rig.mjs takes it; `points` gives those of an element, in so many dimensions, as a list.
json::Json rig_json(
    const Rig& rig,
    const std::function<json::Json(const RigElement& element, std::size_t dimensions)>& points);

/// Reads them; what is wrong goes to `faults`.
Rig read_rig(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

}  // namespace stepwire::plot
