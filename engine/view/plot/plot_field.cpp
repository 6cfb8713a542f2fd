#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

enum class ArrowPivot { tail, middle, tip };

struct FieldOptions {
  double cells = 24.0, scale = 1.0;
  ArrowPivot pivot = ArrowPivot::middle;
};

/// Returns one row for each cell of a lattice of `cells` by `cells`: the one nearest to its centre.
geometry::Curve one_for_each_cell(const geometry::Curve& points, double cells) {
  const geometry::Extent x = geometry::extent_of(points.columns[0]).padded(0.001),
                         y = geometry::extent_of(points.columns[1]).padded(0.001);
  std::map<std::pair<int, int>, std::pair<double, std::size_t>> nearest;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double column = (points.columns[0][row] - x.low) / (x.high - x.low) * cells;
    const double line = (points.columns[1][row] - y.low) / (y.high - y.low) * cells;
    const std::pair<int, int> cell(static_cast<int>(line), static_cast<int>(column));
    const double distance = std::hypot(column - cell.second - 0.5, line - cell.first - 0.5);
    const auto [entry, fresh] = nearest.try_emplace(cell, distance, row);
    if (!fresh && distance < entry->second.first) entry->second = {distance, row};
  }
  geometry::Curve result{std::vector<std::vector<double>>(points.columns.size()), 0};
  for (const auto& [cell, found] : nearest)
    for (std::size_t i = 0; i < points.columns.size(); ++i)
      result.columns[i].push_back(points.columns[i][found.second]);
  return result;
}

double longest_arrow(const geometry::Curve& arrows) {
  double longest = 0.0;
  for (std::size_t i = 0; i < arrows.size(); ++i)
    longest = std::max(longest, std::hypot(arrows.columns[2][i], arrows.columns[3][i]));
  return longest;
}

/// Adds the magnitude of the arrows as the colour, if the file has no other.
void add_magnitude(geometry::Curve& arrows) {
  if (arrows.columns.size() > 4) return;
  arrows.columns.emplace_back();
  for (std::size_t i = 0; i < arrows.columns[0].size(); ++i)
    arrows.columns[4].push_back(std::hypot(arrows.columns[2][i], arrows.columns[3][i]));
}

/// Scales the arrows to the units of the axes, the longest to the length of one cell.
void scale_arrows(geometry::Curve& arrows, double length) {
  const double longest = longest_arrow(arrows);
  if (longest == 0.0) return;
  for (const std::size_t i : {2, 3})
    for (double& value : arrows.columns[i]) value *= length / longest;
}

query::Series magnitude_series(const query::Series& u, const query::Series& v) {
  query::Series series = u;
  series.label = "|(" + u.label + ", " + v.label + ")|";
  return series;
}

/// Returns the share of an arrow that is behind its point.
double share_behind(ArrowPivot pivot) {
  return pivot == ArrowPivot::tip ? 1.0 : pivot == ArrowPivot::middle ? 0.5 : 0.0;
}

VectorsMark mark_of(const geometry::Curve& arrows, ArrowPivot pivot) {
  VectorsMark mark{.line = {"", 1.7}, .pivot = share_behind(pivot), .head = 0.009, .head_angle = 18.0};
  mark.x = arrows.columns[0];
  mark.y = arrows.columns[1];
  mark.dx = arrows.columns[2];
  mark.dy = arrows.columns[3];
  mark.value = arrows.columns[4];
  return mark;
}

void draw_field(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series &x = *panel.find("x"), &y = *panel.find("y"), &u = *panel.find("u"),
                      &v = *panel.find("v");
  const query::Series* color = panel.find("color");
  std::vector<const query::Series*> channels{&x, &y, &u, &v};
  if (color != nullptr) channels.push_back(color);
  plot.label("x", x);
  plot.label("y", y);
  const geometry::Curve points = joined(gather(panel, recording_of(panel, recordings), channels));
  if (points.columns.empty()) return;
  const auto& options = panel.options<FieldOptions>();
  const double cells = std::clamp(options.cells, 1.0, 400.0);
  geometry::Curve arrows = one_for_each_cell(points, cells);
  add_magnitude(arrows);
  plot.color_bar(color != nullptr ? *color : magnitude_series(u, v), geometry::extent_of(arrows.columns[4]));
  plot.cover({points});
  const double width = std::min(plot.x.width(), plot.y.width());
  scale_arrows(arrows, options.scale * (width > 0.0 ? width : 1.0) / cells);
  plot.plane(0.06);
  plot.add(mark_of(arrows, options.pivot));
}

}  // namespace

PlotKind field_plot() {
  PlotKind kind{"field",
                "arrows over the plane, as long and as coloured as they are strong",
                {{"x", "along the horizontal axis", true},
                 {"y", "along the vertical axis", true},
                 {"u", "horizontal part of the arrow", true},
                 {"v", "vertical part of the arrow", true},
                 {"color", "shown as colour instead of the length"}},
                {number_key("cells", "arrows along an axis at most (24)", &FieldOptions::cells),
                 number_key("scale", "length of the longest arrow in cells (1)", &FieldOptions::scale),
                 option_key("pivot", "what of an arrow lies at its point",
                            yaml::form::word({"tail", "middle", "tip"}), &FieldOptions::pivot)},
                true,
                draw_field};
  kind.lacks = {KeyNeeds::legend};
  return kind;
}

}  // namespace stepwire::plot
