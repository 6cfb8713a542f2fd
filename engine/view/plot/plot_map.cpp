#include <algorithm>
#include <cmath>

#include "engine/view/geometry/grid.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

struct MapOptions {
  double cells = 160.0;
  std::optional<double> gap{};  ///< in the unit of x; std::nullopt: a tenth of the width
  std::vector<double> contour{};
};

void cover_cells(const geometry::Grid& grid, PlotBuilder& plot) {
  plot.x.add(grid.x - 0.5 * grid.dx);
  plot.x.add(grid.x + (static_cast<double>(grid.columns) - 0.5) * grid.dx);
  plot.y.add(grid.y - 0.5 * grid.dy);
  plot.y.add(grid.y + (static_cast<double>(grid.rows) - 0.5) * grid.dy);
}

void draw_levels(const std::vector<double>& levels, const geometry::Grid& grid, PlotBuilder& plot) {
  for (const double level : levels) {
    const auto curves = contour(grid, level);
    if (!curves.empty()) plot.add(LineMark{plane_rows(curves), {"#ffffff", 1.2}});
  }
}

void draw_map(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series &x = *panel.find("x"), &y = *panel.find("y"), &color = *panel.find("color");
  const geometry::Curve points = joined(gather(panel, recording_of(panel, recordings), {&x, &y, &color}));
  plot.label("x", x);
  plot.label("y", y);
  plot.spec.closed_frame = true;
  if (points.columns.empty()) return;
  const geometry::Extent across = geometry::extent_of(points.columns[0]);
  const auto& options = panel.options<MapOptions>();
  const auto cells = static_cast<std::size_t>(std::clamp(std::floor(options.cells), 1.0, 1000.0));
  geometry::Grid grid = geometry::make_grid(points, cells, options.gap.value_or(0.1 * across.width()));
  cover_cells(grid, plot);
  plot.plane(0.0);
  grid = geometry::within(grid, plot.x, plot.y);
  plot.color_bar(color, geometry::extent_of(grid.values));
  plot.add(ImageMark{grid.x, grid.y, grid.dx, grid.dy, grid.columns, grid.rows, grid.values});
  draw_levels(options.contour, grid, plot);
}

}  // namespace

PlotKind map_plot() {
  PlotKind kind{
      "map",
      "a heat map over the plane, from rows on a lattice or scattered; nothing is drawn where nothing "
      "was measured",
      {{"x", "along the horizontal axis", true},
       {"y", "along the vertical axis", true},
       {"color", "shown as colour, with a colour bar", true}},
      {number_key("cells", "cells along an axis for scattered rows (160, at most 1000)", &MapOptions::cells),
       number_key("gap",
                  "between scattered rows that are no farther apart the colour goes over linearly (a "
                  "tenth of the width)",
                  &MapOptions::gap, "x"),
       numbers_key("contour", "values of the colour at which lines are drawn", &MapOptions::contour,
                   "color")},
      true,
      draw_map};
  kind.lacks = {KeyNeeds::legend};
  return kind;
}

}  // namespace stepwire::plot
