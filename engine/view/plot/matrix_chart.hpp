#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// Square matrix of numbers from -1 to 1, such as correlations: blue below zero, red above.
struct MatrixChart {
  std::string title;
  std::vector<std::string> names;           ///< of rows and columns
  std::vector<std::vector<double>> values;  ///< [row][column]; NaN is grey
};

/// Returns the chart as a figure of one plot, with its numbers if there is space for them.
FigureSpec figure_of(const MatrixChart& chart);

}  // namespace stepwire::plot
