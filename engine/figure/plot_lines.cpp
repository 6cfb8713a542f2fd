#include "engine/figure/plot_tools.hpp"

namespace stepwire {
namespace {

const Channel across{"x", "along the horizontal axis: EXPR or EXPR in UNIT", true};
const Channel up{"y", "one expression or a list of them", true, true};
const Channel by{"by", "one curve for each value of this, such as a swept parameter"};

void draw_lines(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  draw_curves(panel, recordings, script);
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
  return {"lines", "one or several curves over x, as over time", {across, up, by}, {}, true, draw_lines};
}

PlotKind xy_plot() {
  return {"xy", "y against x in the order of the rows", {across, up, by}, {}, true, draw_xy};
}

PlotKind loop_plot() {
  return {"loop",
          "a loop, such as force over displacement, with the lines x = 0 and y = 0",
          {across, up, by},
          {},
          true,
          draw_loop};
}

}  // namespace stepwire
