#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/block/outline.hpp"
#include "engine/document/document.hpp"
#include "engine/figure/formula.hpp"
#include "engine/figure/names.hpp"
#include "engine/record/recording.hpp"

namespace stepwire {

struct PlotKind;

/// Makes a picture from what was recorded, as SVG.
using Picture = std::function<std::string(std::span<const Recording>)>;

/// What is drawn along an axis or as a colour: a formula, the unit it is drawn in, and its label without
/// unit.
struct Series {
  Formula formula;
  Unit unit;
  std::string unit_text;  ///< empty where the unit is not known
  std::string label;      ///< the expression unless the file says otherwise

  /// "rig.x [mm]".
  std::string axis_label() const;
};

/// A point of the plane with a name, in the units of the axes.
struct MarkedPoint {
  std::string name;
  double x = 0.0, y = 0.0;
};

/// The way of a point over a panel: a line with arrow heads.
struct Motion {
  Series x, y;  ///< in the units of the axes
  std::optional<Formula> where{};
  double heads = 6.0;             ///< arrow heads along each stretch
  std::string color = "#d11a1a";  ///< as gnuplot takes it
  std::size_t recording = 0;
};

/// What happens at one point in each direction: spokes of a disc, as long and as coloured as a value is.
struct Rose {
  Series x, y;          ///< the point, in the units of the axes
  Series angle, value;  ///< direction of a spoke in radians, and what is shown there
  std::optional<Formula> where{};
  std::optional<std::array<double, 2>> at{};  ///< middle of the disc; none: the point itself
  double radius = 0.0;                        ///< of the disc, in the unit of x
  std::string name{};
  std::size_t recording = 0;
};

/// One pair of axes. Numbers are in the units in which they are drawn.
struct Panel {
  using Range = std::array<double, 2>;

  const PlotKind* kind = nullptr;
  std::map<std::string, std::vector<Series>> series;  ///< by key: x, y, color, ...
  std::map<std::string, double> numbers;              ///< numeric options of the kind: bins, view, ...
  std::map<std::string, std::string> words;           ///< labels by key: title, x_label, ...
  std::map<std::string, std::vector<std::string>> word_lists;  ///< options that are lists of words: style
  std::map<std::string, Range> ranges;                         ///< x_range, y_range, z_range, color_range
  std::map<std::string, std::vector<double>> levels;           ///< lists of numbers: contour
  std::vector<Formula> boundaries;  ///< of the plane's x and y in SI; a curve is drawn where one is zero
  std::vector<Outline> regions;     ///< in SI: shaded in the plane, and their lines drawn
  std::vector<MarkedPoint> marks;   ///< drawn on top of everything, with their names
  std::vector<MarkedPoint> texts;   ///< written about their points
  std::vector<Motion> motions;
  std::vector<Rose> roses;
  std::vector<std::string> legend;
  std::optional<Formula> where;
  std::vector<std::size_t> recordings;  ///< for each y, or one
  bool equal = false;
  bool log_x = false, log_y = false, log_color = false;
  bool final_rows = false;  ///< only the last row of each run
  Picture picture;          ///< of a plot that makes its picture alone; without it gnuplot draws

  const Series* find(const std::string& key) const;
};

/// One picture: one panel or several.
struct Figure {
  std::string title;
  std::string caption;
  bool own = false;  ///< the source has no such picture
  std::vector<Panel> panels;
  int columns = 1;
  int width = 0, height = 0;  ///< pixels; 0: as it suits the panels
};

/// Reads the value under the key `figure`: one entry or a list. Everything that is wrong goes to `faults`.
std::vector<Figure> read_figures(const Node& node, const Names& names, Faults& faults);

/// A picture, and what gnuplot had to say about it (empty as a rule).
struct Drawing {
  std::string svg;
  std::string warnings;
};

/// Draws; the same data give the same bits. Throws SurroundingsError where gnuplot, or what else draws, is
/// missing or fails.
Drawing draw(const Figure& figure, std::span<const Recording> recordings);

/// A key of figures with its explanation, for reference pages and the schema.
struct FigureKey {
  std::string name;
  std::string doc;
};

/// Names of all plots: lines, xy, loop, ...
std::vector<FigureKey> plot_names();
/// Keys that the named plot takes; for an empty name the keys of every panel and figure.
std::vector<FigureKey> figure_keys(const std::string& plot);

}  // namespace stepwire
