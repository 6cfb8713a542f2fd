#include "engine/view/render/gnuplot_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "engine/view/render/gnuplot_text.hpp"

namespace stepwire::render {
namespace {

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

}  // namespace

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

}  // namespace stepwire::render
