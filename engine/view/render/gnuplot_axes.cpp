#include "engine/view/render/gnuplot_axes.hpp"

#include <fmt/format.h>

#include "engine/view/render/gnuplot_marks.hpp"
#include "engine/view/render/gnuplot_text.hpp"
#include "engine/view/render/picture.hpp"

namespace stepwire::render {
namespace {

/// Returns the label with its unit.
std::string label_of(const plot::PlotAxis& axis) {
  return axis.unit.empty() ? axis.label : fmt::format("{} [{}]", axis.label, axis.unit);
}

/// Returns "set xtics rotate by -35 ('a' 1, 'b' 2)".
std::string named_ticks(const plot::PlotAxis& axis, const std::string& name) {
  std::vector<std::string> list;
  for (const plot::AxisTick& tick : axis.named_ticks)
    list.push_back(fmt::format("{} {:.9g}", quoted_tic(tick.label), tick.at));
  const std::string turned =
      axis.label_angle == 0.0 ? std::string("norotate") : fmt::format("rotate by {:.6g}", axis.label_angle);
  return fmt::format("set {}tics {}{} ({})\n", name, turned, axis.label_angle > 0.0 ? " right" : "",
                     fmt::join(list, ", "));
}

std::string tick_commands(const plot::PlotAxis& axis, const std::string& name) {
  if (!axis.line && axis.named_ticks.empty()) return fmt::format("unset {}tics\n", name);
  std::string text;
  if (axis.step) text += fmt::format("set {}tics {:.9g}\n", name, *axis.step);
  if (!axis.more_ticks.empty())
    text += fmt::format("set {}tics add ({:.9g})\n", name, fmt::join(axis.more_ticks, ", "));
  if (!axis.named_ticks.empty()) text += named_ticks(axis, name);
  if (!axis.tick_marks) text += fmt::format("set {}tics scale 0\n", name);
  return text;
}

/// Returns the commands of one axis, by gnuplot's name: x, y, z or cb.
std::string axis_commands(const plot::PlotAxis& axis, const std::string& name) {
  std::string text;
  if (const std::string label = label_of(axis); !label.empty())
    text += fmt::format("set {}label {}\n", name, quoted(label));
  if (axis.log) text += fmt::format("set logscale {}\n", name);
  if (axis.range)
    text += fmt::format("set {}range [{:.9g}:{:.9g}]\n", name, (*axis.range)[0], (*axis.range)[1]);
  text += tick_commands(axis, name);
  if (axis.zero_line) text += fmt::format("set {}zeroaxis lt 1 lc rgb '#8a8a8a' lw 1\n", name);
  return text;
}

std::string frame_commands(const plot::PlotSpec& plot) {
  const int sides = plot.closed_frame ? 15 : (plot.x.line ? 1 : 0) + (plot.y.line ? 2 : 0);
  std::string text = fmt::format("set border {}\n", sides);
  if (!plot.x.grid) text += "set grid nox\n";
  if (!plot.y.grid) text += "set grid noy\n";
  return text;
}

std::string space_commands(const plot::PlotSpec& plot) {
  std::string text =
      fmt::format("set view {:.6g},{:.6g},1,1\nset xyplane 0\n", plot.view->elevation, plot.view->azimuth);
  text += "set border 4095 lc rgb '#bdbdbd' lw 0.6\nset grid x y z vertical\nset tics scale 0.4\n";
  // Where x and y meet at the front, their end labels would overlap.
  text += "set xtics offset -1.0,-0.4\nset ytics offset 1.4,-0.5\n";
  for (const char* axis : {"x", "y", "z"}) text += fmt::format("set {}label rotate parallel\n", axis);
  return text + (plot.equal ? "set view equal xyz\n" : "");
}

bool is_all_rectangles(const std::vector<plot::PlotMark>& marks) {
  for (const plot::PlotMark& mark : marks)
    if (!std::holds_alternative<plot::RectanglesMark>(mark)) return false;
  return true;
}

/// Returns the position of the legend. Axes with named rows begin far from the left end, so a long legend
/// centred on them would be cut off.
const char* legend_place(const plot::PlotSpec& plot) {
  if (plot.legend == plot::PlotSpec::Legend::beside) return "outside right center vertical";
  return plot.y.named_ticks.empty() ? "outside top center horizontal" : "tmargin right horizontal";
}

std::string legend_commands(const plot::PlotSpec& plot) {
  if (plot.legend == plot::PlotSpec::Legend::none) return "set key off\n";
  return fmt::format("set key {} Left reverse{}\n", legend_place(plot),
                     is_all_rectangles(plot.marks) ? " samplen 0.6" : "");
}

const char* align_word(plot::TextMark::Align align) {
  return plot::TextMark::alignments[static_cast<std::size_t>(align)];
}

}  // namespace

std::string axes_commands(const plot::PlotSpec& plot) {
  std::string text = legend_commands(plot) + (plot.view ? space_commands(plot) : frame_commands(plot));
  text += axis_commands(plot.x, "x") + axis_commands(plot.y, "y");
  if (plot.z) text += axis_commands(*plot.z, "z");
  if (plot.color) text += axis_commands(*plot.color, "cb");
  return text;
}

std::string palette_command(const plot::PlotSpec& plot) {
  std::vector<std::string> stops;
  for (const plot::ColorStop& stop : plot.palette)
    stops.push_back(fmt::format("{:.6g} {}", stop.at, quoted(stop.color)));
  return stops.empty() ? "" : fmt::format("set palette defined ({}) maxcolors 96\n", fmt::join(stops, ", "));
}

std::string text_commands(const plot::PlotSpec& plot) {
  std::string commands;
  for (const plot::TextMark& text : plot.texts) {
    const std::string color = quoted(text.rim ? rimmed_text : text.color);
    const std::string at = text.in_frame ? fmt::format("at graph {:.9g}, graph {:.9g}", text.x, text.y)
                                         : fmt::format("at {:.9g},{:.9g}", text.x, text.y);
    if (text.dot > 0.0)
      commands += fmt::format("set label '' {} front point pt 7 ps {:.6g} lc rgb {}\n", at,
                              point_size(text.dot), color);
    if (text.text.empty()) continue;
    commands += fmt::format("set label {} {} {} offset {:.2g},{:.2g} front textcolor rgb {} font ',{:.6g}'\n",
                            quoted(text.text), at, align_word(text.align), text.offset[0], text.offset[1],
                            color, text.size);
  }
  return commands;
}

}  // namespace stepwire::render
