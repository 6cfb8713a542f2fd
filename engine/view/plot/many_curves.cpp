#include "engine/view/plot/many_curves.hpp"

#include <algorithm>

#include "engine/view/geometry/density.hpp"

namespace stepwire::plot {
namespace {

constexpr std::size_t most_lines = 200, most_points = 2500;

/// Number of cells along both axes; larger ones for points, since a point fills one cell and a line many.
struct Cells {
  std::size_t across, up;
};
constexpr Cells of_lines{240, 140}, of_points{100, 70};

geometry::Extent shown_extent(const AxisOptions& axis, const geometry::Extent& covered) {
  return axis.range ? geometry::Extent{(*axis.range)[0], (*axis.range)[1]} : covered.padded(0.0);
}

/// Returns each row of joined runs as a curve of its own.
std::vector<geometry::Curve> points_of(const std::vector<geometry::Curve>& curves) {
  std::vector<geometry::Curve> points;
  for (const geometry::Curve& curve : curves)
    for (std::size_t row = 0; row < curve.size(); ++row)
      points.push_back({{{curve.columns[0][row]}, {curve.columns[1][row]}}, curve.group});
  return points;
}

}  // namespace

bool are_many(const Panel& panel, const geometry::Curves& all) {
  if (panel.find("by") || all.several || all.logarithmic) return false;
  if (!panel.final_rows) return all.curves.size() > most_lines;
  std::size_t points = 0;
  for (const geometry::Curve& curve : all.curves) points += curve.size();
  return points > most_points && panel.styles.empty();
}

void draw_density(const geometry::Curves& all, PlotBuilder& plot) {
  plot.cover(all.curves);
  const Panel& panel = plot.panel();
  const Cells cells = panel.final_rows ? of_points : of_lines;
  geometry::Density density = geometry::density_of(panel.final_rows ? points_of(all.curves) : all.curves,
                                                   shown_extent(panel.x, plot.x),
                                                   shown_extent(panel.y, plot.y), cells.across, cells.up);
  const double most = std::ranges::max(density.counts);
  for (double& count : density.counts)
    if (count == 0.0) count = query::nothing;
  plot.range("color", {1.0, std::max(most, 2.0)});
  plot.spec.color->log = true;  // runs often begin together, with far higher counts there
  plot.spec.color->label = panel.color.label.empty() ? "runs" : panel.color.label;
  const double width = density.cell_width(), height = density.cell_height();
  plot.add_below(ImageMark{density.x.low + 0.5 * width, density.y.low + 0.5 * height, width, height,
                           density.columns, density.rows, std::move(density.counts)});
}

}  // namespace stepwire::plot
