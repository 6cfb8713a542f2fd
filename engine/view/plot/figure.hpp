#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/series.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/block/outline.hpp"
#include "engine/simulate/record/recording.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

struct PlotKind;

/// Makes what a panel shows from what was recorded.
using PanelContent = std::function<decltype(PanelSpec::content)(std::span<const record::Recording>)>;

/// A point of the plane with a name, in the units of the axes.
struct MarkedPoint {
  std::string name;
  double x = 0.0, y = 0.0;
};

/// The way of a point over a panel: a line with arrow heads.
struct Motion {
  query::Series x, y;  ///< in the units of the axes
  std::optional<query::Formula> where{};
  double heads = 6.0;             ///< arrow heads along each stretch
  std::string color = "#d11a1a";  ///< as gnuplot takes it
  std::size_t recording = 0;
};

/// What happens at one point in each direction: spokes of a disc, as long and as coloured as a value is.
struct Rose {
  query::Series x, y;          ///< the point, in the units of the axes
  query::Series angle, value;  ///< direction of a spoke in radians, and what is shown there
  std::optional<query::Formula> where{};
  std::optional<std::array<double, 2>> at{};  ///< middle of the disc; none: the point itself
  double radius = 0.0;                        ///< of the disc, in the unit of x
  std::string name{};
  std::size_t recording = 0;
};

/// Number of each run that a channel reduces, and the name of its column.
struct RunNumber {
  std::string name;
  claim::RunFormula formula;
};

/// What a file gives for an axis, in its unit.
struct AxisOptions {
  std::string label{};  ///< empty: that of what is drawn along it
  std::optional<std::array<double, 2>> range{};
  bool log = false;
};

enum class CurveStyle { line, dashes, dots };
enum class ArrowPivot { tail, middle, tip };

/// One pair of axes. Numbers are in the units in which they are drawn. Its keys are the rows of
/// panel_keys() and of the options of its kind.
struct Panel {
  const PlotKind* kind = nullptr;
  std::map<std::string, std::vector<query::Series>> series{};  ///< by key: x, y, color, ...
  std::string title{};
  AxisOptions x{}, y{}, z{}, color{};
  std::vector<query::Formula>
      boundaries{};  ///< of the plane's x and y in SI; a curve is drawn where one is zero
  std::vector<query::NamedOutline> regions{};  ///< in SI: shaded in the plane, and their lines drawn
  bool dashed_regions = false;
  std::vector<MarkedPoint> marks{};  ///< drawn on top of everything, with their names
  std::vector<MarkedPoint> texts{};  ///< written about their points
  std::vector<Motion> motions{};
  std::vector<Rose> roses{};
  std::vector<std::string> legend{};
  std::map<std::string, std::string> names{};  ///< of rows, by the words of the recording
  std::optional<query::Formula> where{};
  std::vector<std::size_t> recordings{};  ///< for each y, or one
  std::vector<RunNumber> numbers{};       ///< that channels make of each run, which then is a row; else empty
  std::vector<std::string> of_runs{};     ///< columns that are beside them, such as swept parameters
  bool equal = false;
  bool final_rows = false;                   ///< only the last row of each run
  PanelContent content{};                    ///< of a plot that has no axes of its own
  bool reads_rows = true;                    ///< of what was recorded
  std::vector<query::NamedFormula> shown{};  ///< in it, by names below that of the panel

  // Options of single kinds; without a value it is as the kind has it.
  std::optional<double> bins{}, cells{}, gap{}, scale{}, elevation{}, azimuth{};
  std::vector<double> contour{}, lines{}, shade{}, shares{};  ///< ends of shaded ranges in pairs
  std::vector<CurveStyle> styles{};                           ///< in the order of the legend
  ArrowPivot pivot = ArrowPivot::middle;
  bool points_only = false;                ///< of rows in space, or of runs without an order
  bool tukey_whiskers = false;             ///< else they reach over all values
  std::optional<std::size_t> reduction{};  ///< of each run, one of claim::reduction_names(); none: each row

  const query::Series* find(const std::string& key) const;
  /// Options of the axis x, y, z or color; of another channel none.
  const AxisOptions& axis(std::string_view name) const;
};

/// One picture: one panel or several.
struct Figure {
  std::string title;
  std::string caption{};
  bool own = false;  ///< the source has no such picture
  std::vector<Panel> panels{};
  int columns = 1;
  int width = 0, height = 0;  ///< pixels; 0: as it suits the panels
};

/// Reads the value under the key `figure`: one entry or a list. Everything that is wrong goes to `faults`.
std::vector<Figure> read_figures(const yaml::Node& node, const query::SymbolTable& names,
                                 yaml::Faults& faults);

/// The keys of each kind of plot, by its name: alone in its picture, or as one of several panels, which a
/// plot that is a picture for itself cannot be.
std::vector<yaml::Key> plot_forms(bool alone);
/// The keys of a picture of several panels.
const yaml::Key& picture_form();
/// What a figure of any kind may have: its plot, the keys of panels and those of pictures.
const yaml::Key& figure_form();

}  // namespace stepwire::plot
