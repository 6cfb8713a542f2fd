#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/figure/grid.hpp"
#include "engine/figure/plot_tools.hpp"

namespace stepwire {
namespace {

/// Centres and values of all cells; an empty row or column is added where there is one alone, which gnuplot
/// refuses.
Curve points_of(const Grid& grid) {
  Curve points{std::vector<std::vector<double>>(3), 0};
  for (std::size_t row = 0; row < std::max<std::size_t>(grid.rows, 2); ++row)
    for (std::size_t column = 0; column < std::max<std::size_t>(grid.columns, 2); ++column) {
      const bool known = row < grid.rows && column < grid.columns;
      points.columns[0].push_back(grid.x + static_cast<double>(column) * grid.dx);
      points.columns[1].push_back(grid.y + static_cast<double>(row) * grid.dy);
      points.columns[2].push_back(known ? grid.at(column, row) : std::numeric_limits<double>::quiet_NaN());
    }
  return points;
}

void cover_cells(const Grid& grid, Script& script) {
  script.x.add(grid.x - 0.5 * grid.dx);
  script.x.add(grid.x + (static_cast<double>(grid.columns) - 0.5) * grid.dx);
  script.y.add(grid.y - 0.5 * grid.dy);
  script.y.add(grid.y + (static_cast<double>(grid.rows) - 0.5) * grid.dy);
}

void draw_levels(const Panel& panel, const Grid& grid, Script& script) {
  const auto levels = panel.levels.find("contour");
  if (levels == panel.levels.end()) return;
  for (const double level : levels->second) {
    const auto curves = contour(grid, level);
    if (!curves.empty()) script.plot(script.data(curves) + " using 1:2 with lines lc rgb '#ffffff' lw 1.2");
  }
}

void draw_map(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const Series &x = *panel.find("x"), &y = *panel.find("y"), &color = *panel.find("color");
  const Curve points = joined(gather(panel, recording_of(panel, recordings), {&x, &y, &color}));
  script.label("x", x);
  script.label("y", y);
  script.set("set border 15\nset grid back");
  if (points.columns.empty()) return;
  const Extent across = extent_of(points.columns[0]);
  const auto cells =
      static_cast<std::size_t>(std::clamp(std::floor(number_or(panel, "cells", 160.0)), 1.0, 1000.0));
  Grid grid = make_grid(points, cells, number_or(panel, "gap", 0.1 * (across.high - across.low)));
  cover_cells(grid, script);
  script.plane(0.0);
  grid = within(grid, script.x, script.y);
  script.color_bar(color, extent_of(grid.values));
  script.plot(script.data({points_of(grid)}) + " using 1:2:3 with image");
  draw_levels(panel, grid, script);
}

}  // namespace

PlotKind map_plot() {
  return {"map",
          "a heat map over the plane, from rows on a lattice or scattered; nothing is drawn where nothing "
          "was measured",
          {{"x", "along the horizontal axis", true},
           {"y", "along the vertical axis", true},
           {"color", "shown as colour, with a colour bar", true}},
          {{"cells", "cells along an axis for scattered rows (160, at most 1000)"},
           {"gap",
            "between scattered rows that are no farther apart the colour goes over linearly (a tenth of the "
            "width)",
            "x"},
           {"contour", "values of the colour at which lines are drawn", "color", true}},
          true,
          draw_map};
}

}  // namespace stepwire
