#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// Bar with a piece for each kind.
struct Bar {
  std::string label;
  std::vector<double> pieces;  ///< non-negative
  bool aside = false;          ///< true below the others, after a gap
};

/// Kind of piece, with its colour.
struct BarKind {
  std::string name;
  std::string color;  ///< "#0072B2"
};

/// Chart of horizontal bars, the first on top, each stacked from pieces of several kinds, with its length
/// (one decimal) at its end.
struct BarChart {
  std::string title;
  std::string axis;            ///< quantity and unit of the length
  std::vector<BarKind> kinds;  ///< at most five, with their names in one line
  std::vector<Bar> bars;
};

/// Returns the chart as a figure of one plot.
FigureSpec figure_of(const BarChart& chart);

}  // namespace stepwire::plot
