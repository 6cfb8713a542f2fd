#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/text/text_table.hpp"
#include "engine/view/plot/plot_mark.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::plot {

/// A place along an axis with its label.
struct AxisTick {
  double at = 0.0;
  std::string label;

  bool operator==(const AxisTick&) const = default;
  static auto fields() { return std::tuple{field("at", &AxisTick::at), field("label", &AxisTick::label)}; }
};

/// One axis. All numbers along it are in its unit.
struct PlotAxis {
  std::string label{};
  std::string unit{};                            ///< as people print it: mm, m/s², °; empty: not known
  std::optional<std::array<double, 2>> range{};  ///< left or lower end first; none: as far as the marks
  bool log = false;
  std::optional<double> step{};         ///< between ticks; none: as it suits the range
  std::vector<double> more_ticks{};     ///< labelled beside the powers of ten of a logarithmic axis
  std::vector<AxisTick> named_ticks{};  ///< in place of numbers
  double label_angle = 0.0;             ///< by which the labels of ticks are turned [degrees]
  bool line = true;                     ///< without it and named ticks there are no ticks either
  bool tick_marks = true;
  bool grid = true;
  bool zero_line = false;  ///< a line where the other axis is zero

  bool operator==(const PlotAxis&) const = default;
  static auto fields() {
    return std::tuple{field("label", &PlotAxis::label),
                      field("unit", &PlotAxis::unit),
                      field("range", &PlotAxis::range),
                      field("log", &PlotAxis::log),
                      field("step", &PlotAxis::step),
                      field("more_ticks", &PlotAxis::more_ticks),
                      field("named_ticks", &PlotAxis::named_ticks),
                      field("label_angle", &PlotAxis::label_angle),
                      field("line", &PlotAxis::line),
                      field("tick_marks", &PlotAxis::tick_marks),
                      field("grid", &PlotAxis::grid),
                      field("zero_line", &PlotAxis::zero_line)};
  }
};

/// A colour of the colour axis; colours between two stops go over linearly.
struct ColorStop {
  double at = 0.0;  ///< share of the axis
  std::string color;

  bool operator==(const ColorStop&) const = default;
  static auto fields() { return std::tuple{field("at", &ColorStop::at), field("color", &ColorStop::color)}; }
};

/// From where three axes are seen [degrees].
struct SpaceView {
  double elevation = 62.0, azimuth = 35.0;

  bool operator==(const SpaceView&) const = default;
  static auto fields() {
    return std::tuple{field("elevation", &SpaceView::elevation), field("azimuth", &SpaceView::azimuth)};
  }
};

/// Axes with all that is drawn between them. A renderer takes nothing else.
struct PlotSpec {
  enum class Legend { none, above, beside };
  static constexpr std::array legends{"none", "above", "beside"};
  std::string title{};
  PlotAxis x{}, y{};
  std::optional<PlotAxis> z{};      ///< upwards, of a plot in space
  std::optional<PlotAxis> color{};  ///< has a bar beside the plot
  std::vector<ColorStop> palette{};
  std::optional<SpaceView> view{};  ///< of a plot in space
  bool equal = false;               ///< one unit is as long along all axes
  bool closed_frame = false;        ///< lines on all four sides
  Legend legend = Legend::none;
  /// Place of the axes in the picture: left, top, width, height [px]; none: as their labels leave room.
  std::optional<std::array<double, 4>> frame{};
  std::vector<PlotMark> marks{};  ///< later ones cover earlier ones
  std::vector<TextMark> texts{};

  static auto fields() {
    return std::tuple{field("title", &PlotSpec::title),
                      field("x", &PlotSpec::x),
                      field("y", &PlotSpec::y),
                      field("z", &PlotSpec::z),
                      field("color", &PlotSpec::color),
                      field("palette", &PlotSpec::palette),
                      field("view", &PlotSpec::view),
                      field("equal", &PlotSpec::equal),
                      field("closed_frame", &PlotSpec::closed_frame),
                      field("legend", &PlotSpec::legend),
                      field("frame", &PlotSpec::frame),
                      field("marks", &PlotSpec::marks),
                      field("texts", &PlotSpec::texts)};
  }
};

/// A block diagram or a mechanism, as the drawing module takes it.
struct DrawnGraph {
  enum class Kind { diagram, rig } kind = Kind::diagram;
  json::Json graph;
};

/// Instants of a scene side by side.
struct SceneInstants {
  std::shared_ptr<const scene::Scene> scene;
  std::vector<std::vector<scene::SceneShape>>
      shapes;                      ///< of each instant, in the order in which they are drawn
  std::vector<std::string> words;  ///< below each instant
};

/// A panel and its place in the picture, from the upper left corner [px].
struct PanelSpec {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  std::variant<PlotSpec, text::TextTable, DrawnGraph, SceneInstants> content;
};

/// One picture. A panel that is no plot has it for itself and is as large as it needs to be.
struct FigureSpec {
  std::string title{};
  double width = 0.0, height = 0.0;  ///< [px]; 0: as its one panel needs it
  bool aligned = false;              ///< panels above each other have their axes in line
  std::vector<PanelSpec> panels{};
};

/// All that a picture holds; README.md of this folder describes it.
json::Json figure_json(const FigureSpec& figure);

}  // namespace stepwire::plot
