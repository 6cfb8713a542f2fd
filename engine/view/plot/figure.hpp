#pragma once

#include <any>
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

/// Function that computes the content of a panel from recordings.
using PanelContent = std::function<decltype(PanelSpec::content)(std::span<const record::Recording>)>;

/// Named point of the plane, in the units of the axes.
struct MarkedPoint {
  std::string name;
  double x = 0.0, y = 0.0;
};

/// Path of a point over a panel: a line with arrow heads.
struct Motion {
  query::Series x, y;  ///< in the units of the axes
  std::optional<query::Formula> where{};
  double heads = 6.0;             ///< number of arrow heads along each curve
  std::string color = "#d11a1a";  ///< as in gnuplot
  std::size_t recording = 0;
};

/// Values at one point for each direction, drawn as spokes of a disc whose length and colour are the value.
struct Rose {
  query::Series x, y;          ///< the point, in the units of the axes
  query::Series angle, value;  ///< direction of a spoke [rad], and its value
  std::optional<query::Formula> where{};
  std::optional<std::array<double, 2>> at{};  ///< centre of the disc; std::nullopt: the point itself
  double radius = 0.0;                        ///< of the disc, in the unit of x
  std::string name{};
  std::size_t recording = 0;
};

/// Reduced value of each run in a channel, and the name of its column.
struct RunNumber {
  std::string name;
  claim::RunFormula formula;
};

/// Options of an axis in a file, in its unit.
struct AxisOptions {
  std::string label{};  ///< empty: that of the quantities along it
  std::optional<std::array<double, 2>> range{};
  bool log = false;
};

/// Panel with one pair of axes. Numbers are in the displayed units. Its keys are the rows of panel_keys() and
/// of the options of its kind.
struct Panel {
  const PlotKind* kind = nullptr;
  std::map<std::string, std::vector<query::Series>> series{};  ///< by key: x, y, color, ...
  std::string title{};
  AxisOptions x{}, y{}, z{}, color{};
  std::vector<query::Formula>
      boundaries{};  ///< expressions of the plane's x and y in SI, with a curve where one is zero
  std::vector<query::NamedOutline> regions{};  ///< in SI: shaded in the plane, with their lines
  bool dashed_regions = false;
  std::vector<MarkedPoint> marks{};  ///< in front of everything, with their names
  std::vector<MarkedPoint> texts{};  ///< centred at their points
  std::vector<Motion> motions{};
  std::vector<Rose> roses{};
  std::vector<std::string> legend{};
  std::map<std::string, std::string> names{};  ///< names of rows, by the words of the recording
  std::optional<query::Formula> where{};
  std::vector<std::size_t> recordings{};  ///< one for each y, or one for all
  std::vector<RunNumber> numbers{};       ///< computed from each run, which then is a row; else empty
  std::vector<std::string> of_runs{};     ///< further columns of these rows, such as swept parameters
  bool equal = false;
  bool final_rows = false;                   ///< true if only the last row of each run is drawn
  PanelContent content{};                    ///< of a plot without axes
  bool reads_rows = true;                    ///< true if it reads rows of recordings
  bool reads_all_rows = false;               ///< true if it reads each row of a run, also with `final_rows`
  bool points_only = false;                  ///< true for rows in space, or of unordered runs, without lines
  std::vector<query::NamedFormula> shown{};  ///< quantities in it, by names below that of the panel
  std::any own_options{};                    ///< struct of options that the source of its kind declares

  /// Returns the options of its kind; those of a new struct if the file has none of them.
  template <class Options>
  const Options& options() const {
    static const Options usual{};
    const auto* own = std::any_cast<Options>(&own_options);
    return own ? *own : usual;
  }
  template <class Options>
  Options& options() {
    if (!std::any_cast<Options>(&own_options)) own_options = Options{};
    return *std::any_cast<Options>(&own_options);
  }
  const query::Series* find(const std::string& key) const;
  /// Returns the options of the axis x, y, z or color; defaults for any other channel.
  const AxisOptions& axis(std::string_view name) const;
};

/// Picture with one panel or several.
struct Figure {
  std::string title;
  std::string caption{};
  bool own = false;  ///< true if the source has no such picture
  std::vector<Panel> panels{};
  int columns = 1;
  int width = 0, height = 0;  ///< pixels; 0: by the panels
};

/// Reads the value under the key `figure`: one entry or a list. Collects all faults.
std::vector<Figure> read_figures(const yaml::Node& node, const query::SymbolTable& names,
                                 yaml::Faults& faults);

/// Returns the keys of each kind of plot, by its name: alone in its picture, or as one of several panels. A
/// plot without axes cannot be one of several.
std::vector<yaml::Key> plot_forms(bool alone);
/// Returns the keys of a picture of several panels.
const yaml::Key& picture_form();
/// Returns all keys that a figure of any kind may have: its plot, the keys of panels and those of pictures.
const yaml::Key& figure_form();

}  // namespace stepwire::plot
