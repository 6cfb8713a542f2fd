#include <cmath>

#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

/// How many values lie in each of so many bins of an extent.
RectanglesMark bins_of(const std::vector<double>& values, const geometry::Extent& extent, std::size_t count) {
  const double width = extent.width() / static_cast<double>(count);
  RectanglesMark bins{.color = curve_color(0), .edge = "#ffffff"};
  for (std::size_t i = 0; i < count; ++i) {
    bins.x_low.push_back(extent.low + static_cast<double>(i) * width);
    bins.x_high.push_back(extent.low + static_cast<double>(i + 1) * width);
  }
  bins.y_low.assign(count, 0.0);
  bins.y_high.assign(count, 0.0);
  for (const double value : values) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, (value - extent.low) / width));
    bins.y_high[std::min(bin, count - 1)] += 1.0;
  }
  return bins;
}

void draw_bins(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series& x = *panel.find("x");
  const geometry::Curve all = joined(gather(panel, recording_of(panel, recordings), {&x}));
  plot.label("x", x);
  draw_histogram(all.columns.empty() ? std::vector<double>{} : all.columns[0], plot);
}

}  // namespace

void draw_histogram(const std::vector<double>& values, PlotBuilder& plot) {
  const Panel& panel = plot.panel();
  plot.spec.y.label = "rows";
  plot.spec.x.grid = false;
  if (values.empty()) return;
  geometry::Extent extent = geometry::extent_of(values);
  for (const double line : panel.lines) extent.add(line);
  extent = extent.padded(panel.lines.empty() ? 0.0 : 0.02);
  RectanglesMark bins =
      bins_of(values, extent,
              static_cast<std::size_t>(std::clamp(std::floor(panel.bins.value_or(30.0)), 1.0, 1000.0)));
  const double top = 1.05 * geometry::extent_of(bins.y_high).high;
  plot.range("x", extent);
  plot.range("y", {0.0, top});
  plot.add(std::move(bins));
  for (const double line : panel.lines)
    plot.add(LineMark{{{{line, line}, {0.0, top}, {}, {}}}, {curve_color(1), 2.4}});
}

PlotKind histogram_plot() {
  return {"histogram",
          "how many rows have which value",
          {{"x", "the value that is counted", true}},
          {number_key("bins", "number of bins (30)", &Panel::bins),
           numbers_key("lines", "a value, or a list, at which a line is drawn", &Panel::lines, "x")},
          false,
          draw_bins};
}

}  // namespace stepwire::plot
