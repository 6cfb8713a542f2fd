#include "engine/view/render/gnuplot_renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "engine/view/plot/plot_mark.hpp"
#include "engine/view/plot/plot_spec.hpp"
#include "engine/view/render/gnuplot.hpp"
#include "engine/view/render/gnuplot_text.hpp"
#include "engine/view/render/picture.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::render {
namespace {

/// Generates gnuplot's commands for the marks of one panel, in order.
class GnuplotMarks {
 public:
  /// `panel` is the prefix of the names of data blocks, so that panels of one picture do not share them.
  explicit GnuplotMarks(std::string panel) : panel_(std::move(panel)) {}

  void operator()(const plot::LineMark& mark);
  void operator()(const plot::BandMark& mark);
  void operator()(const plot::SpanMark& mark);
  void operator()(const plot::AreaMark& mark);
  void operator()(const plot::PointsMark& mark);
  void operator()(const plot::BoxesMark& mark);
  void operator()(const plot::RectanglesMark& mark);
  void operator()(const plot::ImageMark& mark);
  void operator()(const plot::VectorsMark& mark);
  void operator()(const plot::SurfaceMark& mark);

  /// Returns data blocks and settings, followed by `plot` or, with `space`, `splot` with all marks.
  std::string text(bool space) const;

 private:
  using Columns = std::vector<const std::vector<double>*>;

  /// Writes pieces as a data block, with a gap between two of them, and returns its name.
  std::string data(const std::vector<Columns>& pieces, const char* gap = "\n\n");
  void plot(const std::string& item, const std::string& legend = {}, const std::string& behind = {});

  std::string panel_, commands_;
  std::vector<std::string> items_;
  std::size_t blocks_ = 0;
  bool has_surface_ = false;  ///< true after a surface
};

using RowColumns = std::vector<const std::vector<double>*>;

RowColumns columns_of(const plot::MarkRows& rows) {
  RowColumns columns{&rows.x, &rows.y};
  for (const auto* more : {&rows.z, &rows.value})
    if (!more->empty()) columns.push_back(more);
  return columns;
}

std::vector<RowColumns> columns_of(const std::vector<plot::MarkRows>& curves) {
  std::vector<RowColumns> pieces;
  for (const plot::MarkRows& rows : curves) pieces.push_back(columns_of(rows));
  return pieces;
}

/// Returns "1:2:3" for three columns.
std::string using_all(const std::vector<RowColumns>& pieces) {
  std::string list = "1";
  for (std::size_t i = 1; i < pieces.front().size(); ++i) list += fmt::format(":{}", i + 1);
  return list;
}

std::string color_word(const std::string& color) {
  return color.empty() ? "palette" : "rgb " + quoted(color);
}

/// Returns "lw 1.6 dt (5,8) lc rgb '#0072B2'". gnuplot's dashes are in half line widths.
std::string words_of(const plot::LineStyle& line) {
  std::vector<double> halves;
  for (const double length : line.dash) halves.push_back(2.0 * length);
  const std::string dash = halves.empty() ? "" : fmt::format(" dt ({:.6g})", fmt::join(halves, ","));
  return fmt::format("lw {:.6g}{} lc {}", line.width, dash, color_word(line.color));
}

const char* symbol_word(plot::PointsMark::Symbol symbol) {
  if (symbol == plot::PointsMark::Symbol::asterisk) return "3";
  return symbol == plot::PointsMark::Symbol::ring ? "6" : "7";
}

/// Centres and values of all cells. A single row or column is split into two of half its size, since gnuplot
/// refuses an image with one.
struct ImageCells {
  std::vector<double> x, y, values;

  explicit ImageCells(const plot::ImageMark& image) {
    const std::size_t across = image.columns == 1 ? 2 : 1, up = image.rows == 1 ? 2 : 1;
    const auto place = [](double first, double step, std::size_t i, std::size_t parts) {
      return parts == 1 ? first + static_cast<double>(i) * step
                        : first + (0.5 * static_cast<double>(i) - 0.25) * step;
    };
    for (std::size_t row = 0; row < up * image.rows; ++row)
      for (std::size_t column = 0; column < across * image.columns; ++column) {
        x.push_back(place(image.x, image.dx, column, across));
        y.push_back(place(image.y, image.dy, row, up));
        values.push_back(image.values[row / up * image.columns + column / across]);
      }
  }
};

/// Returns gnuplot's point size for a diameter [px] in pictures with its font of 13 pixels.
double point_size(double diameter) {
  constexpr double unit = 0.75 * 13.0;  // diameter of a point of size 1
  return diameter / unit;
}

std::string GnuplotMarks::data(const std::vector<Columns>& pieces, const char* gap) {
  const std::string block = fmt::format("${}{}", panel_, blocks_++);
  commands_ += block + " << EOD\n";
  auto out = std::back_inserter(commands_);
  for (const Columns& columns : pieces) {
    for (std::size_t row = 0; row < columns.front()->size(); ++row)
      for (const auto* column : columns)
        fmt::format_to(out, "{:.7g}{}", (*column)[row], column == columns.back() ? '\n' : ' ');
    // Two empty lines separate curves; after one alone gnuplot connects curves in space to a mesh.
    if (&columns != &pieces.back()) commands_ += gap;
  }
  commands_ += "EOD\n";
  return block;
}

void GnuplotMarks::plot(const std::string& item, const std::string& legend, const std::string& behind) {
  items_.push_back(item + (legend.empty() ? " notitle" : " title " + quoted(legend)) + behind);
}

void GnuplotMarks::operator()(const plot::LineMark& mark) {
  const auto pieces = columns_of(mark.curves);
  if (pieces.empty()) return;
  // gnuplot draws surfaces after everything else, but lines with hidden3d after them. The frame and the grid
  // are lines of hidden3d too, unless they are behind.
  const auto is_line = [](const plot::MarkRows& rows) { return rows.x.size() > 1; };
  if (has_surface_ && std::ranges::any_of(mark.curves, is_line))
    commands_ += "set hidden3d front\nset border behind\nset grid behind\n";
  const std::string with =
      mark.dots > 0.0 ? fmt::format("linespoints pt 7 ps {:.6g}", point_size(mark.dots)) : "lines";
  plot(fmt::format("{} using {} with {} {}", data(pieces), using_all(pieces), with, words_of(mark.line)),
       mark.legend);
}

void GnuplotMarks::operator()(const plot::BandMark& mark) {
  plot(fmt::format("{} using 1:2:3 with filledcurves fc {} fs transparent solid {:.6g} noborder",
                   data({{&mark.x, &mark.low, &mark.high}}), color_word(mark.color), mark.opacity));
}

void GnuplotMarks::operator()(const plot::SpanMark& mark) {
  commands_ += fmt::format(
      "set object rectangle from {:.9g}, graph 0 to {:.9g}, graph 1 behind fc {} fs solid noborder\n",
      mark.low, mark.high, color_word(mark.color));
}

void GnuplotMarks::operator()(const plot::AreaMark& mark) {
  plot(fmt::format("{} using 1:2 with filledcurves closed fc {} fs solid noborder",
                   data({{&mark.x, &mark.y}}), color_word(mark.color)));
}

void GnuplotMarks::operator()(const plot::PointsMark& mark) {
  const std::vector<Columns> rows{columns_of(mark.rows)};
  plot(fmt::format("{} using {} with points pt {} ps {:.6g} lw {:.6g} lc {}", data(rows), using_all(rows),
                   symbol_word(mark.symbol), point_size(mark.size), mark.width, color_word(mark.color)),
       mark.legend);
}

void GnuplotMarks::operator()(const plot::BoxesMark& mark) {
  const std::string block =
      data({{&mark.x, &mark.lower, &mark.low_whisker, &mark.high_whisker, &mark.upper}});
  plot(fmt::format("{0} using 1:2:3:4:5:({1:.6g}) with candlesticks fs solid 0.2 border lc {2} fc {2} "
                   "lc {2} lw 1.3",
                   block, mark.width, color_word(mark.color)),
       mark.legend, " whiskerbars 0.5");
}

void GnuplotMarks::operator()(const plot::RectanglesMark& mark) {
  Columns columns{&mark.x_low, &mark.x_high, &mark.y_low, &mark.y_high};
  if (mark.color.empty()) columns.push_back(&mark.value);
  const std::string edge = mark.edge.empty() ? "noborder" : "border lc " + color_word(mark.edge);
  plot(fmt::format("{} using (($1+$2)/2):(($3+$4)/2):1:2:3:4{} with boxxyerror fs solid 1.0 {} fc {}",
                   data({columns}), mark.color.empty() ? ":5" : "", edge, color_word(mark.color)),
       mark.legend);
}

void GnuplotMarks::operator()(const plot::ImageMark& mark) {
  const ImageCells cells(mark);
  plot(data({{&cells.x, &cells.y, &cells.values}}) + " using 1:2:3 with image");
}

void GnuplotMarks::operator()(const plot::VectorsMark& mark) {
  Columns columns{&mark.x, &mark.y, &mark.dx, &mark.dy};
  if (mark.line.color.empty()) columns.push_back(&mark.value);
  const std::string head = mark.head == 0.0
                               ? "nohead"
                               : fmt::format("filled head size screen {:.6g},{:.6g},70{}", mark.head,
                                             mark.head_angle, mark.fixed_heads ? " fixed" : "");
  plot(fmt::format("{} using ($1-{:.6g}*$3):($2-{:.6g}*$4):3:4{} with vectors {} {}", data({columns}),
                   mark.pivot, mark.pivot, mark.line.color.empty() ? ":5" : "", head, words_of(mark.line)),
       mark.legend);
}

void GnuplotMarks::operator()(const plot::SurfaceMark& mark) {
  const auto pieces = columns_of(mark.lines);
  commands_ += "set pm3d depthorder corners2color mean\n";
  has_surface_ = true;
  plot(fmt::format("{} using {} with pm3d", data(pieces, "\n"), using_all(pieces)));
}

std::string GnuplotMarks::text(bool space) const {
  // Without marks the axes are drawn too.
  if (items_.empty()) return commands_ + "plot 2 notitle\n";
  return commands_ + (space ? "splot " : "plot ") + fmt::format("{}\n", fmt::join(items_, ", \\\n  "));
}

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

/// Returns gnuplot's commands for the axes, the frame, the grid and the legend of a plot.
std::string axes_commands(const plot::PlotSpec& plot) {
  std::string text = legend_commands(plot) + (plot.view ? space_commands(plot) : frame_commands(plot));
  text += axis_commands(plot.x, "x") + axis_commands(plot.y, "y");
  if (plot.z) text += axis_commands(*plot.z, "z");
  if (plot.color) text += axis_commands(*plot.color, "cb");
  return text;
}

/// Returns the command that sets the colours of the colour axis; an empty text without one.
std::string palette_command(const plot::PlotSpec& plot) {
  std::vector<std::string> stops;
  for (const plot::ColorStop& stop : plot.palette)
    stops.push_back(fmt::format("{:.6g} {}", stop.at, quoted(stop.color)));
  return stops.empty() ? "" : fmt::format("set palette defined ({}) maxcolors 96\n", fmt::join(stops, ", "));
}

/// Returns the commands that write texts in front of all marks.
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

/// Returns the step that gnuplot chooses for the numbers along an axis (quantize_normal_tics in its axis.c).
double chosen_step(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length))), count = 20.0 * power / length;
  const double steps[][2] = {{40.0, 0.05}, {20.0, 0.1}, {10.0, 0.2}, {4.0, 0.5}, {2.0, 1.0}};
  for (const auto& [least, step] : steps)
    if (count > least) return step * power;
  return 2.0 * power;
}

/// Returns the letters of the longest number along an axis; 0 for texts and logarithms.
std::size_t longest_number(const plot::PlotAxis& axis) {
  if (!axis.range || axis.log || !axis.named_ticks.empty()) return 0;
  const auto [low, high] = *axis.range;
  const double step = axis.step.value_or(chosen_step(high - low));
  std::size_t longest = 0;
  const double first = std::ceil(low / step);
  for (int k = 0; k < 100 && step * (first + k) <= high; ++k)
    longest = std::max(longest, fmt::format("{:.6g}", step * (first + k)).size());
  return longest;
}

/// Returns the margins. Panels above each other have equal ones, and a colour bar leaves the axes as wide as
/// those without one.
std::string margins(const plot::FigureSpec& figure) {
  if (!figure.aligned) return {};
  bool colored = false;
  std::size_t letters = 5;  // five letters and the label have room in ten
  for (const plot::PanelSpec& panel : figure.panels) {
    const auto& plot = std::get<plot::PlotSpec>(panel.content);
    colored = colored || plot.color.has_value();
    letters = std::max(letters, longest_number(plot.y));
  }
  return fmt::format("set lmargin {}\nset rmargin {}\n{}", letters + 5, colored ? 15 : 3,
                     "set colorbox user origin graph 1.02, graph 0 size graph 0.035, graph 1\n");
}

std::string place(const plot::FigureSpec& figure, const plot::PanelSpec& panel, bool equal) {
  return fmt::format("set origin {:.6f},{:.6f}\nset size {}{:.6f},{:.6f}\n", panel.left / figure.width,
                     1.0 - (panel.top + panel.height) / figure.height, equal ? "ratio -1 " : "",
                     panel.width / figure.width, panel.height / figure.height);
}

std::string frame_of(const plot::FigureSpec& figure, const plot::PlotSpec& plot) {
  if (!plot.frame) return {};
  const auto [left, top, width, height] = *plot.frame;
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\nset bmargin "
      "at screen {:.6f}\n",
      left / figure.width, (left + width) / figure.width, 1.0 - top / figure.height,
      1.0 - (top + height) / figure.height);
}

std::string title_of(const plot::FigureSpec& figure) {
  return fmt::format(
      "set label {} at screen 0.5, screen {:.6f} center font ',{:.3g}' textcolor rgb '#111111'\n",
      quoted(figure.title), 1.0 - 18.0 / figure.height,
      svg::fitted_size(figure.title, 15.0, figure.width - 20.0));
}

std::string panel_title(const std::string& title, double width) {
  constexpr double aside = 70.0;  // a title is centred above the axes, which are not in the middle
  return title.empty() ? "" : "set title " + fitted_title(title, width - aside) + "\n";
}

std::string marks_of(const plot::PlotSpec& plot, std::size_t panel) {
  GnuplotMarks marks(fmt::format("p{}d", panel));
  for (const plot::PlotMark& mark : plot.marks) std::visit(marks, mark);
  return marks.text(plot.view.has_value());
}

}  // namespace

std::string gnuplot_script(const plot::FigureSpec& figure) {
  std::string script = picture_terminal(figure.width, figure.height) + "set multiplot\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const plot::PanelSpec& panel = figure.panels[i];
    const auto& plot = std::get<plot::PlotSpec>(panel.content);
    script += picture_style() + palette_command(plot) + margins(figure) + place(figure, panel, plot.equal) +
              frame_of(figure, plot);
    if (i == 0 && !figure.title.empty()) script += title_of(figure);
    script += panel_title(plot.title, panel.width) + axes_commands(plot) + text_commands(plot);
    script += marks_of(plot, i);
  }
  return script + "unset multiplot\n";
}

Drawing render_gnuplot(const plot::FigureSpec& figure) {
  GnuplotAnswer answer = run_gnuplot(gnuplot_script(figure));
  const bool has_color_scale = std::ranges::any_of(figure.panels, [](const plot::PanelSpec& panel) {
    return std::get<plot::PlotSpec>(panel.content).color.has_value();
  });
  return {finished_picture(std::move(answer.output), figure.title, has_color_scale),
          std::move(answer.complaints)};
}

}  // namespace stepwire::render
