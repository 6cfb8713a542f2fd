#include "engine/view/plot/plot_tools.hpp"

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

const std::vector<CurveStyle>& styles_of(const Panel& panel) {
  return panel.options<CurveOptions>().styles;
}

/// True for a number of curves at which lines would hide each other. False with several y or a `by`, whose
/// curves are distinguished by colour.
bool are_many(const Panel& panel, const geometry::Curves& all) {
  if (panel.find("by") || all.several || all.logarithmic) return false;
  if (!panel.final_rows) return all.curves.size() > most_lines;
  std::size_t points = 0;
  for (const geometry::Curve& curve : all.curves) points += curve.size();
  return points > most_points && styles_of(panel).empty();
}

/// Draws the number of curves through each cell as a colour.
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

constexpr double picture_budget = 14000.0;  ///< of a picture, which keeps it below some 300 kB
constexpr std::size_t max_in_legend = 8;

std::string legend_text(const Panel& panel, const query::Series& y, const geometry::Curves& curves,
                        std::size_t group, std::size_t entry) {
  if (entry < panel.legend.size()) return panel.legend[entry];
  const bool several = panel.series.at("y").size() > 1;
  if (curves.labels.empty()) return several ? y.label : "";
  return several ? y.label + ", " + curves.legends[group] : curves.legends[group];
}

/// Returns a label that applies to all y.
query::Series common_label(const std::vector<query::Series>& all) {
  query::Series common = all.front();
  for (const query::Series& series : all) {
    if (common.unit_text.empty()) common.unit_text = series.unit_text;
    if (&series != &all.front()) common.label += ", " + series.label;
  }
  if (common.label.size() > 44) common.label = "";
  return common;
}

/// Returns the style of a curve. Later curves are thinner, so that a curve behind them remains visible.
LineStyle line_of(const Panel& panel, std::size_t entry, bool several) {
  LineStyle line{curve_color(entry), entry == 0 && several ? 2.4 : 1.6};
  if (entry >= styles_of(panel).size()) return line;
  const CurveStyle style = styles_of(panel)[entry];
  line.width = style == CurveStyle::dots ? 3.4 : style == CurveStyle::dashes ? 1.4 : 1.6;
  if (style == CurveStyle::dots) line.dash = {0.25, 1.75};
  if (style == CurveStyle::dashes) line.dash = {4.0, 2.5};
  return line;
}

/// Returns the size of dots. Final rows have dots if the file has no style.
double dots_of(const Panel& panel, std::size_t entry) {
  return panel.final_rows && entry >= styles_of(panel).size() ? dot_size : 0.0;
}

geometry::Curve with_group_value(geometry::Curve curve, const geometry::Curves& all) {
  curve.columns.emplace_back(curve.size(), all.groups[curve.group]);
  return curve;
}

/// Returns the drawn rows of a group: all for points, else as many as its line needs.
std::vector<geometry::Curve> drawn(const Panel& panel, const geometry::Curves& all, std::size_t group,
                                   std::size_t budget) {
  return panel.final_rows ? geometry::cut(all, group, budget) : geometry::thinned(all, group, budget);
}

/// Adds curves as a line, or their rows as points.
void add_rows(const Panel& panel, const std::vector<geometry::Curve>& curves, LineMark line,
              PlotBuilder& plot) {
  if (!panel.points_only) return plot.add(std::move(line));
  constexpr double diameter = 3.5;
  for (const geometry::Curve& curve : curves) {
    plot.add(PointsMark{.rows = plane_rows(curve),
                        .size = diameter,
                        .color = line.line.color,
                        .legend = &curve == &curves.front() ? line.legend : ""});
  }
}

/// Returns the budget of rows of each of `parts` curves of a plot.
std::size_t rows_for(const PlotBuilder& plot, std::size_t parts) {
  return static_cast<std::size_t>(picture_budget * plot.share / static_cast<double>(parts));
}

/// Draws many groups with the value of `by` as a colour.
void draw_by_color(const Panel& panel, const geometry::Curves& all, PlotBuilder& plot) {
  for (std::size_t group = 0; group < all.groups.size(); ++group) {
    auto curves = drawn(panel, all, group, rows_for(plot, all.groups.size()));
    plot.cover(curves);
    for (geometry::Curve& curve : curves) curve = with_group_value(std::move(curve), all);
    LineStyle line = line_of(panel, 0, false);
    line.color.clear();
    add_rows(panel, curves, LineMark{plane_rows(curves), line, dots_of(panel, 0)}, plot);
  }
  plot.color_bar(*panel.find("by"), geometry::extent_of(all.groups));
}

void draw_in_legend(const Panel& panel, const query::Series& y, const geometry::Curves& all,
                    std::size_t& entry, PlotBuilder& plot) {
  const std::size_t budget = rows_for(plot, panel.series.at("y").size() * all.groups.size());
  for (std::size_t group = 0; group < all.groups.size(); ++group, ++entry)
    draw_group(all, group, entry, budget, legend_text(panel, y, all, group, entry), plot);
}

}  // namespace

geometry::Curve joined(const geometry::Curves& all) {
  geometry::Curve result;
  for (const geometry::Curve& curve : all.curves) {
    result.columns.resize(curve.columns.size());
    for (std::size_t i = 0; i < curve.columns.size(); ++i)
      result.columns[i].insert(result.columns[i].end(), curve.columns[i].begin(), curve.columns[i].end());
  }
  return result;
}

void draw_group(const geometry::Curves& all, std::size_t group, std::size_t entry, std::size_t budget,
                const std::string& legend, PlotBuilder& plot) {
  const Panel& panel = plot.panel();
  const auto curves = drawn(panel, all, group, budget);
  plot.cover(curves);
  add_rows(panel, curves,
           LineMark{plane_rows(curves), line_of(panel, entry, all.several), dots_of(panel, entry), legend},
           plot);
}

void draw_curves(const std::vector<NumberCurve>& curves, PlotBuilder& plot) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    geometry::Curves all = curves_of(plot.panel(), {curves[i].x, curves[i].y});
    all.several = curves.size() > 1;
    for (std::size_t group = 0; group < all.groups.size(); ++group)
      draw_group(all, group, i, rows_for(plot, curves.size()), curves[i].legend, plot);
  }
}

void name_axis(PlotAxis& axis, const std::string& label, const std::string& unit) {
  axis.label = label;
  axis.unit = unit.empty() ? "" : query::printed_unit(unit);
}

void draw_band(const std::vector<geometry::Curve>& curves, PlotBuilder& plot) {
  for (const geometry::Curve& curve : curves) {
    for (const std::size_t edge : {1, 2})
      for (const double value : curve.columns[edge]) plot.y.add(value);
    plot.add_below(BandMark{curve.columns[0], curve.columns[1], curve.columns[2], curve_color(curve.group)});
  }
}

void draw_spans(const std::vector<double>& ends, PlotBuilder& plot) {
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) plot.add(SpanMark{ends[i], ends[i + 1], "#eeeadd"});
}

void set_line_ranges(PlotBuilder& plot) {
  // The time axis ends with the recording; the other axis has a margin.
  const geometry::Extent all = plot.x;
  plot.plane(0.05);
  if (!plot.panel().x.range) plot.x = all.padded(0.0);
  plot.range("x", plot.x);
}

void draw_curves(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const auto &all_x = panel.series.at("x"), &all_y = panel.series.at("y");
  std::size_t entry = 0;
  for (std::size_t i = 0; i < all_y.size(); ++i) {
    const query::Series& x = all_x[std::min(i, all_x.size() - 1)];
    geometry::Curves all = gather(panel, recording_of(panel, recordings, i), {&x, &all_y[i]});
    all.several = all_y.size() > 1;
    if (are_many(panel, all))
      draw_density(all, plot);
    else if (all.groups.size() > max_in_legend && all_y.size() == 1 && panel.legend.empty())
      draw_by_color(panel, all, plot);
    else
      draw_in_legend(panel, all_y[i], all, entry, plot);
  }
  plot.label("x", common_label(all_x));
  plot.label("y", common_label(all_y));
}

const record::Recording& recording_of(const Panel& panel, std::span<const record::Recording> recordings,
                                      std::size_t index) {
  return recordings[panel.recordings[std::min(index, panel.recordings.size() - 1)]];
}

}  // namespace stepwire::plot
