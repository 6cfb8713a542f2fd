#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// A square of numbers from -1 to 1 between things, such as correlations: blue below zero, red above.
struct MatrixChart {
  std::string title;
  std::vector<std::string> names;           ///< of rows and columns alike
  std::vector<std::vector<double>> values;  ///< [row][column]; nan is left grey
};

/// The chart as a figure of one plot, with its numbers where there is room for them.
FigureSpec figure_of(const MatrixChart& chart);

}  // namespace stepwire::plot
