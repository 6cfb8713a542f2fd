#include "engine/figure/matrix_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/gnuplot.hpp"
#include "engine/figure/picture.hpp"
#include "engine/figure/script.hpp"

namespace stepwire {
namespace {

constexpr double cell = 44.0, letter = 7.2, head = 44.0, bar = 90.0;  // [pixels]
constexpr std::size_t most_with_numbers = 16;

/// Whole cells as coloured rectangles: an image of gnuplot would be a bitmap.
std::string cells(const MatrixChart& chart, bool known) {
  std::string block;
  for (std::size_t row = 0; row < chart.values.size(); ++row)
    for (std::size_t column = 0; column < chart.values[row].size(); ++column)
      if (const double value = chart.values[row][column]; std::isfinite(value) == known)
        block += fmt::format("{} {} {:.3f}\n", column, row, known ? value : 0.0);
  return block;
}

std::string labels(const MatrixChart& chart) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < chart.names.size(); ++i)
    list.push_back(fmt::format("{} {}", quoted_tic(chart.names[i]), i));
  const std::string all = fmt::format("{}", fmt::join(list, ", "));
  return fmt::format("set xtics ({}) rotate by 45 right scale 0\nset ytics ({}) scale 0\n", all, all);
}

}  // namespace

std::string draw(const MatrixChart& chart) {
  std::size_t longest = 1;
  for (const std::string& name : chart.names) longest = std::max(longest, name.size());
  const auto count = static_cast<double>(std::max<std::size_t>(1, chart.names.size()));
  const double margin = 20.0 + letter * static_cast<double>(longest);
  const double width = std::max(360.0, margin + cell * count + bar), height = head + cell * count + margin;
  const double side = cell * count;
  std::string script = picture_terminal(width, height) + picture_style() + labels(chart);
  script +=
      fmt::format("set label {} at screen 0.5, screen {:.6f} center font ',15' textcolor rgb '#111111'\n",
                  quoted(chart.title), 1.0 - 20.0 / height);
  script += fmt::format("set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n", margin / width,
                        (margin + side) / width);
  script += fmt::format("set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n", 1.0 - head / height,
                        margin / height);
  script += fmt::format("set xrange [-0.5:{0}]\nset yrange [{0}:-0.5]\nunset grid\nunset key\n", count - 0.5);
  script +=
      "set cbrange [-1:1]\nset cbtics 0.5\n"
      "set palette defined (-1 '#2166ac', -0.5 '#92c5de', 0 '#ffffff', 0.5 '#f4a582', 1 '#b2182b')\n"
      "set style fill solid 1.0 noborder\n";
  std::vector<std::string> items;
  for (const bool known : {true, false}) {
    const std::string block = cells(chart, known);
    if (block.empty()) continue;
    const std::string name = known ? "$known" : "$unknown";
    script += name + " << EOD\n" + block + "EOD\n";
    items.push_back(name + " using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5)" +
                    (known ? ":3 with boxxyerror fc palette" : " with boxxyerror fc rgb '#cccccc'"));
    if (known && chart.names.size() <= most_with_numbers)
      items.push_back(
          "$known using 1:2:(abs($3) < 0.005 ? '0.00' : sprintf('%.2f', $3)):(abs($3) > 0.75 ? 0xffffff : "
          "0x222222) "
          "with labels font ',10' textcolor rgb variable");
  }
  script += fmt::format("plot {}\n", fmt::join(items, ", \\\n  "));
  return finished_picture(run_gnuplot(script).output, chart.title);
}

}  // namespace stepwire
