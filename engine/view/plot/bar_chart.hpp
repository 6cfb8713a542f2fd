#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// One bar, made of a piece for each kind.
struct Bar {
  std::string label;
  std::vector<double> pieces;  ///< not below 0
  bool aside = false;          ///< drawn below the others, behind a gap
};

/// What pieces of one colour are.
struct BarKind {
  std::string name;
  std::string color;  ///< "#0072B2"
};

/// Horizontal bars below each other, the first on top, each stacked of pieces of several kinds, with
/// its length (one decimal) behind it.
struct BarChart {
  std::string title;
  std::string axis;            ///< what the length of a bar is, with its unit
  std::vector<BarKind> kinds;  ///< at most five, whose names stand in one line
  std::vector<Bar> bars;
};

/// The chart as a figure of one plot.
FigureSpec figure_of(const BarChart& chart);

}  // namespace stepwire::plot
