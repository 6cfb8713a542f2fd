#include <cmath>

#include "engine/figure/plot_tools.hpp"

namespace stepwire {
namespace {

/// Middle of each bin and the number of values in it.
Curve bins_of(const std::vector<double>& values, const Extent& extent, std::size_t count) {
  const double width = (extent.high - extent.low) / static_cast<double>(count);
  Curve bins{std::vector<std::vector<double>>(2), 0};
  for (std::size_t i = 0; i < count; ++i)
    bins.columns[0].push_back(extent.low + (static_cast<double>(i) + 0.5) * width);
  bins.columns[1].assign(count, 0.0);
  for (const double value : values) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, (value - extent.low) / width));
    bins.columns[1][std::min(bin, count - 1)] += 1.0;
  }
  return bins;
}

void draw_histogram(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const Series& x = *panel.find("x");
  const Curve all = joined(gather(panel, recording_of(panel, recordings), {&x}));
  script.label("x", x);
  script.set("set ylabel 'rows'\nset style fill solid 1.0 border lc rgb '#ffffff'\nset grid nox");
  if (all.columns.empty()) return;
  Extent extent = extent_of(all.columns[0]);
  const std::vector<double> lines =
      panel.levels.contains("lines") ? panel.levels.at("lines") : std::vector<double>{};
  for (const double line : lines) extent.add(line);
  extent = extent.padded(lines.empty() ? 0.0 : 0.02);
  const auto count =
      static_cast<std::size_t>(std::clamp(std::floor(number_or(panel, "bins", 30.0)), 1.0, 1000.0));
  const Curve bins = bins_of(all.columns[0], extent, count);
  script.range("x", extent);
  const double top = 1.05 * extent_of(bins.columns[1]).high;
  script.range("y", {0.0, top});
  script.plot(script.data({bins}) + " using 1:2 with boxes fc rgb '" + curve_color(0) + "' lc rgb '#ffffff'");
  for (const double line : lines)
    script.plot(script.data({Curve{{{line, line}, {0.0, top}}, 0}}) +
                " using 1:2 with lines lw 2.4 lc rgb '" + curve_color(1) + "'");
}

}  // namespace

PlotKind histogram_plot() {
  return {
      "histogram",
      "how many rows have which value",
      {{"x", "the value that is counted", true}},
      {{"bins", "number of bins (30)"}, {"lines", "a value, or a list, at which a line is drawn", "x", true}},
      false,
      draw_histogram};
}

}  // namespace stepwire
