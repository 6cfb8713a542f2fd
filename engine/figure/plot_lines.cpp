#include <fmt/format.h>

#include "engine/figure/plot_tools.hpp"

namespace stepwire {
namespace {

const Channel across{"x", "along the horizontal axis: EXPR or EXPR in UNIT", true};
const Channel up{"y", "one expression or a list of them", true, true};
const Channel by{"by", "one curve for each value of this, such as a swept parameter"};

const Channel low{"low", "lower edge of a shaded band, such as an interval around y"};
const Channel high{"high", "upper edge of the band"};
const Channel reference{"reference", "for each y a value to hold it against, drawn dashed in its colour",
                        false, true};
const Channel each_across{"x", "along the horizontal axis: one expression, or one for each y", true, true};
const Option style{.key = "style",
                   .doc = "how the curves are drawn, in the order of the legend: line, dashes or dots",
                   .list = true,
                   .words = {"line", "dashes", "dots"}};
const Option shade{.key = "shade",
                   .doc = "ends of a range of x that is shaded, or of several: [0 s, 2 s]",
                   .axis = "x",
                   .list = true,
                   .pairs = true};

/// What lies between `low` and `high`.
void draw_band(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const Series *bottom = panel.find("low"), *top = panel.find("high");
  if (!bottom || !top) return;
  const Curves band = gather(panel, recording_of(panel, recordings), {panel.find("x"), bottom, top});
  for (const Curve& curve : band.curves) {
    for (const std::size_t edge : {1, 2})
      for (const double value : curve.columns[edge]) script.y.add(value);
    script.plot_below(
        fmt::format("{} using 1:2:3 with filledcurves fc rgb '{}' fs transparent solid 0.2 noborder",
                    script.data({curve}), curve_color(curve.group)));
  }
}

void draw_references(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const auto found = panel.series.find("reference");
  for (std::size_t i = 0; found != panel.series.end() && i < found->second.size(); ++i) {
    const Curves all =
        gather(panel, recording_of(panel, recordings, i), {panel.find("x"), &found->second[i]});
    if (all.curves.empty()) continue;
    script.cover(all.curves);
    script.plot(fmt::format("{} using 1:2 with lines dt 2 lw 1.4 lc rgb '{}'", script.data(all.curves),
                            curve_color(i)));
  }
}

void draw_shades(const Panel& panel, Script& script) {
  const auto found = panel.levels.find("shade");
  if (found == panel.levels.end()) return;
  const auto& ends = found->second;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    script.set(
        fmt::format("set object rectangle from {:.9g}, graph 0 to {:.9g}, graph 1 behind "
                    "fc rgb '#eeeadd' fs solid noborder",
                    ends[i], ends[i + 1]));
}

void draw_lines(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  draw_shades(panel, script);
  draw_curves(panel, recordings, script);
  draw_references(panel, recordings, script);
  draw_band(panel, recordings, script);
  if (panel.equal) return script.plane(0.04);
  // The axis of time begins and ends with the record; the other one leaves the curves some room.
  const Extent all = script.x;
  script.plane(0.05);
  script.range("x", script.x = panel.ranges.contains("x_range") ? script.x : all.padded(0.0));
}

void draw_xy(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  draw_curves(panel, recordings, script);
  script.plane(0.05);
}

void draw_loop(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  draw_xy(panel, recordings, script);
  // Quadrants tell whether a loop takes or gives energy.
  script.set("set xzeroaxis lt 1 lc rgb '#8a8a8a' lw 1\nset yzeroaxis lt 1 lc rgb '#8a8a8a' lw 1");
}

}  // namespace

PlotKind lines_plot() {
  return {"lines",
          "one or several curves over x, as over time",
          {across, up, low, high, by, reference},
          {shade, style},
          true,
          draw_lines};
}

PlotKind xy_plot() {
  return {"xy", "y against x in the order of the rows", {each_across, up, by}, {style}, true, draw_xy};
}

PlotKind loop_plot() {
  return {"loop",
          "a loop, such as force over displacement, with the lines x = 0 and y = 0",
          {each_across, up, by},
          {style},
          true,
          draw_loop};
}

}  // namespace stepwire
