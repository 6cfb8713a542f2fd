#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

const Channel across{"x", "along the horizontal axis: EXPR or EXPR in UNIT", true};
const Channel up{"y", "one expression or a list of them", true, true};
const Channel by{"by", "one curve for each value of this, such as a swept parameter"};

const Channel low{"low", "lower edge of a shaded band, such as an interval around y"};
const Channel high{"high", "upper edge of the band"};
const Channel reference{"reference", "for each y a value to hold it against, drawn dashed in its colour",
                        false, true};
const Channel each_across{"x", "along the horizontal axis: one expression, or one for each y", true, true};
const PanelKey style{"style", "how the curves are drawn, in the order of the legend: line, dashes or dots",
                     yaml::form::one_or_list(yaml::form::word({"line", "dashes", "dots"})),
                     [](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
                       for (const yaml::Node& item : node.as_list())
                         if (const auto index = read.word(item, style.of.front()))
                           panel.options<CurveOptions>().styles.push_back(static_cast<CurveStyle>(*index));
                     }};

PanelKey shade_key() {
  PanelKey key = numbers_key("shade", "ends of a range of x that is shaded, or of several: [0 s, 2 s]",
                             &CurveOptions::shade, "x");
  key.set = [read_numbers = key.set](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
    read_numbers(panel, node, read);
    if (panel.options<CurveOptions>().shade.size() % 2 != 0)
      read.fault(node.mark, "needs two numbers for each range, its beginning and its end");
  };
  return key;
}

/// Shades the range between `low` and `high`.
void draw_interval(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series *bottom = panel.find("low"), *top = panel.find("high");
  if (bottom && top)
    draw_band(gather(panel, recording_of(panel, recordings), {panel.find("x"), bottom, top}).curves, plot);
}

void draw_references(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const auto found = panel.series.find("reference");
  for (std::size_t i = 0; found != panel.series.end() && i < found->second.size(); ++i) {
    const geometry::Curves all =
        gather(panel, recording_of(panel, recordings, i), {panel.find("x"), &found->second[i]});
    if (all.curves.empty()) continue;
    plot.cover(all.curves);
    plot.add(LineMark{plane_rows(all.curves), {curve_color(i), 1.4, {2.5, 4.0}}});
  }
}

void draw_lines(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  draw_curves(panel, recordings, plot);
  draw_references(panel, recordings, plot);
  draw_interval(panel, recordings, plot);
  if (!plot.spec.marks.empty()) draw_spans(panel.options<CurveOptions>().shade, plot);
  if (panel.equal) return plot.plane(0.04);
  set_line_ranges(plot);
}

void draw_xy(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  draw_curves(panel, recordings, plot);
  plot.plane(0.05);
}

void draw_loop(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  draw_xy(panel, recordings, plot);
  // The quadrant of a point is the direction of energy flow in a loop.
  plot.spec.x.zero_line = plot.spec.y.zero_line = true;
}

}  // namespace

PlotKind lines_plot() {
  return {"lines",
          "one or several curves over x, as over time",
          {across, up, low, high, by, reference},
          {shade_key(), style},
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

}  // namespace stepwire::plot
