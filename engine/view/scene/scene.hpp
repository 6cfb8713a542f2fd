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

/// A kind of object.
struct SceneKind {
  std::string name;
  std::string doc;  ///< of the value under its name
  std::size_t min_points = 1, max_points = 1;
  std::string color;  ///< where the file gives none
};

/// All kinds of objects.
const std::vector<SceneKind>& scene_kinds();

/// A colour by its name, such as blue.
struct SceneColor {
  std::string name;
  std::string value;  ///< "#rrggbb"
};

/// The colours that have names.
const std::vector<SceneColor>& scene_colors();

/// A place among the formulas of a scene.
using FormulaIndex = std::size_t;

/// A colour that an object has while a condition holds, or whenever no earlier one does.
struct ColorRule {
  SceneColor color;
  std::optional<FormulaIndex> when;
};

/// A wall of a region: one line of its boundary.
struct SceneWall {
  std::vector<std::array<double, 2>> points;  ///< [m]
  bool closed = true;
};

/// One object. Its numbers are formulas of the scene.
struct SceneObject {
  const SceneKind* kind = nullptr;
  std::string name;
  std::vector<std::array<FormulaIndex, 2>> points;  ///< x, y [m]
  std::optional<FormulaIndex> radius, width, size;  ///< [m]; without one as it suits the view
  std::optional<FormulaIndex> when;                 ///< it is shown while this is true
  std::vector<ColorRule> colors;                    ///< the first that holds; the last always does
  std::vector<SceneWall> walls;
  std::optional<SceneColor> crossed;                   ///< of the wall that is crossed
  std::optional<FormulaIndex> distance;                ///< beyond the boundary of walls while above 0 [m]
  std::optional<std::array<FormulaIndex, 2>> nearest;  ///< point of the boundary, tells which wall is crossed
  std::string text;
};

/// What of a run is animated, and how fast.
struct SceneAnimation {
  std::optional<double> from, to;       ///< [s]
  double speed = 1.0;                   ///< seconds of the run in one of the animation
  std::optional<query::Formula> where;  ///< of several runs that with the first row for which this is true
};

/// Objects in the plane that follow signals: what somebody at the device sees. Coordinates are metres, y
/// upward.
struct Scene {
  std::array<double, 2> x{}, y{};   ///< what is in view [m]
  std::string background = "dark";  ///< dark, light, or "#rrggbb"
  std::vector<SceneObject> objects;
  std::vector<query::Formula> formulas;
  SceneAnimation animation;
  std::size_t recording = 0;  ///< which one has the signals
  yaml::Mark mark;
};

/// The keys of the section `scene`.
const yaml::Key& scene_form();

/// Reads the section `scene`. Everything that is wrong goes to `faults`.
Scene read_scene(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

/// What is shown of an object at one instant, in the colour that it has then.
struct SceneShape {
  const SceneObject* object = nullptr;
  std::size_t wall = 0;                       ///< which one of its walls, whose points stand there
  std::vector<std::array<double, 2>> points;  ///< of what is no wall [m]
  double size = 0.0;                          ///< radius, or height of letters [m]
  double width = 0.0;                         ///< of its line [m]
  SceneColor color;
  bool crossed = false;  ///< a wall beyond which the object's distance lies
  bool shown = true;     ///< false also where a coordinate is no number
};

/// A scene whose formulas know where in a row their signals stand.
class SceneView {
 public:
  /// Throws std::invalid_argument if a signal is not among the columns.
  SceneView(const Scene& scene, const std::vector<std::string>& columns);

  /// What is shown where the columns have these values: for any row the same shapes, in the order in which
  /// they are drawn, with other places, colours and visibility. The scene has to outlive them.
  std::vector<SceneShape> shapes(std::span<const double> row) const;

 private:
  const Scene& scene_;
  std::vector<std::vector<std::size_t>> places_;  ///< of the columns of each formula
};

/// One instant of a recording as a row for a view of it.
std::vector<double> row_of(const record::Recording& recording, std::size_t row);
/// The view of a scene onto its recording.
SceneView view_of(const Scene& scene, const record::Recording& recording);

}  // namespace stepwire::scene
