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

/// Labelled place along an axis.
struct AxisTick {
  double at = 0.0;
  std::string label;

  bool operator==(const AxisTick&) const = default;
  static auto fields() { return std::tuple{field("at", &AxisTick::at), field("label", &AxisTick::label)}; }
};

/// Axis of a plot. All numbers along it are in its unit.
struct PlotAxis {
  std::string label{};
  std::string unit{};                            ///< Printed unit: mm, m/s², °; empty if unknown.
  std::optional<std::array<double, 2>> range{};  ///< Lower end first; std::nullopt: by the marks.
  bool log = false;
  std::optional<double> step{};         ///< Distance of ticks; std::nullopt: by the range.
  std::vector<double> more_ticks{};     ///< Further labels of a logarithmic axis.
  std::vector<AxisTick> named_ticks{};  ///< Ticks that replace numbers.
  double label_angle = 0.0;             ///< Rotation of the tick labels [degrees].
  bool line = true;                     ///< False also removes unnamed ticks.
  bool tick_marks = true;
  bool grid = true;
  bool zero_line = false;  ///< true for a line at the zero of the other axis

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

/// Colour of the colour axis; colours between two stops are interpolated linearly.
struct ColorStop {
  double at = 0.0;  ///< share of the axis
  std::string color;

  bool operator==(const ColorStop&) const = default;
  static auto fields() { return std::tuple{field("at", &ColorStop::at), field("color", &ColorStop::color)}; }
};

/// View direction of three axes [degrees].
struct SpaceView {
  double elevation = 62.0, azimuth = 35.0;

  bool operator==(const SpaceView&) const = default;
  static auto fields() {
    return std::tuple{field("elevation", &SpaceView::elevation), field("azimuth", &SpaceView::azimuth)};
  }
};

/// Axes with all marks between them: the complete input of a renderer.
struct PlotSpec {
  enum class Legend { none, above, beside };
  static constexpr std::array legends{"none", "above", "beside"};
  std::string title{};
  PlotAxis x{}, y{};
  std::optional<PlotAxis> z{};      ///< vertical, for a plot in space
  std::optional<PlotAxis> color{};  ///< with a bar beside the plot
  std::vector<ColorStop> palette{};
  std::optional<SpaceView> view{};  ///< for a plot in space
  bool equal = false;               ///< true for equal scales of all axes
  bool closed_frame = false;        ///< true for lines on all four sides
  Legend legend = Legend::none;
  /// Position of the axes in the picture: left, top, width, height [px]; std::nullopt: by the size of their
  /// labels.
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

/// Block diagram or mechanism, in the format of the drawing module.
struct DrawnGraph {
  enum class Kind { diagram, rig } kind = Kind::diagram;
  json::Json graph;
};

/// Instants of a scene side by side.
struct SceneInstants {
  std::shared_ptr<const scene::Scene> scene;
  std::vector<std::vector<scene::SceneShape>> shapes;  ///< of each instant, in drawing order
  std::vector<std::string> words;                      ///< below each instant
};

/// Panel and its place in the picture, from the upper left corner [px].
struct PanelSpec {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  std::variant<PlotSpec, text::TextTable, DrawnGraph, SceneInstants> content;
};

/// Picture. A panel that is no plot is alone in it and determines its own size.
struct FigureSpec {
  std::string title{};
  double width = 0.0, height = 0.0;  ///< [px]; 0: by its one panel
  bool aligned = false;              ///< true for panels above each other with aligned axes
  std::vector<PanelSpec> panels{};
};

/// Returns the content of a picture; README.md of this folder documents it.
json::Json figure_json(const FigureSpec& figure);

}  // namespace stepwire::plot
