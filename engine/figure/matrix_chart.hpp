#pragma once

#include <string>
#include <vector>

namespace stepwire {

/// A square of numbers from -1 to 1 between things, such as correlations: blue below zero, red above.
struct MatrixChart {
  std::string title;
  std::vector<std::string> names;           ///< of rows and columns alike
  std::vector<std::vector<double>> values;  ///< [row][column]; nan is left grey
};

/// The chart as SVG, with its numbers where there is room for them. Throws SurroundingsError where gnuplot is
/// missing.
std::string draw(const MatrixChart& chart);

}  // namespace stepwire
