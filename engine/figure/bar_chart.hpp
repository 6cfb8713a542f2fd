#pragma once

#include <string>
#include <vector>

namespace stepwire {

/// One bar, made of a piece for each kind.
struct Bar {
  std::string label;
  std::vector<double> pieces;  ///< not below 0
  bool aside = false;          ///< drawn below the others, behind a gap
};

/// Horizontal bars below each other, the first on top, each stacked of pieces of several kinds.
struct BarChart {
  std::string title;
  std::string axis;                ///< what the length of a bar is, with its unit
  std::vector<std::string> kinds;  ///< a colour each
  std::vector<Bar> bars;
};

/// The chart as SVG. Throws SurroundingsError where gnuplot is missing.
std::string draw(const BarChart& chart);

}  // namespace stepwire
