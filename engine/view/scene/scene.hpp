#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::scene {

/// Kind of object.
struct SceneKind {
  std::string name;
  std::string doc;  ///< of the value under its name
  std::size_t min_points = 1, max_points = 1;
  std::string color;  ///< default colour
};

/// Returns all kinds of objects.
const std::vector<SceneKind>& scene_kinds();

/// Named colour, such as blue.
struct SceneColor {
  std::string name;
  std::string value;  ///< "#rrggbb"
};

/// Returns the named colours.
const std::vector<SceneColor>& scene_colors();

/// Index into the formulas of a scene.
using FormulaIndex = std::size_t;

/// Colour of an object while a condition holds, or without one, if no earlier rule applies.
struct ColorRule {
  SceneColor color;
  std::optional<FormulaIndex> when;
};

/// Wall of a region: one line of its boundary.
struct SceneWall {
  std::vector<std::array<double, 2>> points;  ///< [m]
  bool closed = true;
};

/// Object of a scene. Its numbers are formulas of the scene.
struct SceneObject {
  const SceneKind* kind = nullptr;
  std::string name;
  std::vector<std::array<FormulaIndex, 2>> points;  ///< x, y [m]
  std::optional<FormulaIndex> radius, width, size;  ///< [m]; std::nullopt: by the view
  std::optional<FormulaIndex> when;                 ///< condition of its visibility
  std::vector<ColorRule> colors;                    ///< the first that holds applies; the last always holds
  std::vector<SceneWall> walls;
  std::optional<SceneColor> crossed;                   ///< colour of the crossed wall
  std::optional<FormulaIndex> distance;                ///< beyond the boundary of walls while above 0 [m]
  std::optional<std::array<FormulaIndex, 2>> nearest;  ///< boundary point that determines the crossed wall
  std::string text;
};

/// Animated part of a run, and its speed.
struct SceneAnimation {
  std::optional<double> from, to;       ///< [s]
  double speed = 1.0;                   ///< seconds of the run in one of the animation
  std::optional<query::Formula> where;  ///< of several runs, selects that of the first true row
};

/// Picture of objects in the plane that follow signals, as a person at the device sees it. Coordinates are
/// metres, y upward.
struct Scene {
  std::array<double, 2> x{}, y{};   ///< displayed range [m]
  std::string background = "dark";  ///< dark, light, or "#rrggbb"
  std::vector<SceneObject> objects;
  std::vector<query::Formula> formulas;
  SceneAnimation animation;
  std::size_t recording = 0;  ///< index of the recording with the signals
  yaml::Mark mark;
};

/// Returns the keys of the section `scene`.
const yaml::Key& scene_form();

/// Reads the section `scene`; collects all faults.
Scene read_scene(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

/// Shape of an object at one instant, with its colour at that time.
struct SceneShape {
  const SceneObject* object = nullptr;
  std::size_t wall = 0;                       ///< index of the wall
  std::vector<std::array<double, 2>> points;  ///< of other objects [m]
  double size = 0.0;                          ///< radius, or height of letters [m]
  double width = 0.0;                         ///< of its line [m]
  SceneColor color;
  bool crossed = false;  ///< true for a wall that the object has crossed
  bool shown = true;     ///< false also for a non-finite coordinate
};

/// Scene whose formulas are bound to columns of a row.
class SceneView {
 public:
  /// Throws std::invalid_argument if a signal is not among the columns.
  SceneView(const Scene& scene, const std::vector<std::string>& columns);

  /// Returns the shapes for a row of column values. Every row has the same shapes, in drawing order, with
  /// other places, colours and visibility. The scene must outlive them.
  std::vector<SceneShape> shapes(std::span<const double> row) const;

 private:
  const Scene& scene_;
  std::vector<std::vector<std::size_t>> places_;  ///< columns of each formula
};

/// Returns one instant of a recording as a row for a view of it.
std::vector<double> row_of(const record::Recording& recording, std::size_t row);
/// Returns the view of a scene for its recording.
SceneView view_of(const Scene& scene, const record::Recording& recording);

}  // namespace stepwire::scene
