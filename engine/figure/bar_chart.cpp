#include "engine/figure/bar_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "engine/figure/gnuplot.hpp"
#include "engine/figure/picture.hpp"
#include "engine/figure/script.hpp"

namespace stepwire {
namespace {

constexpr double width = 680.0, row_height = 22.0, frame_height = 104.0;  // [pixels]
constexpr double half_bar = 0.36, gap = 0.6;                              // [rows]

/// Where each bar's middle lies, counted downwards in rows.
std::vector<double> places(const std::vector<Bar>& bars) {
  std::vector<double> result;
  double place = 0.0;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (i > 0 && bars[i].aside && !bars[i - 1].aside) place += gap;
    result.push_back(place);
    place += 1.0;
  }
  return result;
}

std::string labels(const std::vector<Bar>& bars, const std::vector<double>& at) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < bars.size(); ++i)
    list.push_back(fmt::format("{} {}", quoted_tic(bars[i].label), at[i]));
  return fmt::format("set ytics ({})\n", fmt::join(list, ", "));
}

/// The pieces of one kind: start, end and middle of each.
std::string pieces(const std::vector<Bar>& bars, const std::vector<double>& at, std::size_t kind) {
  std::string block = fmt::format("$k{} << EOD\n", kind);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto& sizes = bars[i].pieces;
    const double start =
        std::accumulate(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(kind), 0.0);
    block += fmt::format("{:.7g} {:.7g} {:.7g}\n", start, start + sizes[kind], at[i]);
  }
  return block + "EOD\n";
}

double length(const Bar& bar) {
  return std::accumulate(bar.pieces.begin(), bar.pieces.end(), 0.0);
}

/// The end of each bar.
std::string ends(const std::vector<Bar>& bars, const std::vector<double>& at) {
  std::string block = "$ends << EOD\n";
  for (std::size_t i = 0; i < bars.size(); ++i)
    block += fmt::format("{:.7g} {:.7g}\n", length(bars[i]), at[i]);
  return block + "EOD\n";
}

double longest(const std::vector<Bar>& bars) {
  double most = 0.0;
  for (const Bar& bar : bars) most = std::max(most, length(bar));
  return most > 0.0 ? most : 1.0;
}

/// Title on top, the kinds in one line below it, the bars without a frame.
std::string frame(const BarChart& chart, double height, double last) {
  std::string text = fmt::format(
      "set label {} at screen 0.5, screen {:.6f} center font ',15' textcolor rgb '#111111'\nset xlabel {}\n",
      quoted(chart.title), 1.0 - 20.0 / height, quoted(chart.axis));
  text += "set border 1\nset ytics scale 0 textcolor rgb '#111111'\nset grid noy\nset tmargin 3.2\n";
  text += fmt::format(
      "set key at screen 0.5, screen {:.6f} center top horizontal Left reverse samplen 0.6 width -4\n",
      1.0 - 32.0 / height);
  text += "set style fill solid 1.0 noborder\n";
  return text +
         fmt::format("set xrange [0:{:.7g}]\nset yrange [{}:-0.7]\n", 1.1 * longest(chart.bars), last + 0.7);
}

}  // namespace

std::string draw(const BarChart& chart) {
  const auto at = places(chart.bars);
  const double last = at.empty() ? 0.0 : at.back();
  const double height = frame_height + row_height * (last + 1.0);
  std::string script = picture_terminal(width, height) + picture_style() + frame(chart, height, last);
  script += labels(chart.bars, at);
  std::vector<std::string> items;
  for (std::size_t kind = 0; kind < chart.kinds.size(); ++kind) {
    script += pieces(chart.bars, at, kind);
    items.push_back(fmt::format("$k{} using 1:3:1:2:($3-{}):($3+{}) with boxxyerror fc rgb '{}' title {}",
                                kind, half_bar, half_bar, chart.kinds[kind].color,
                                quoted(chart.kinds[kind].name)));
  }
  script += ends(chart.bars, at);
  items.push_back(
      "$ends using 1:2:(sprintf('%.1f', $1)) with labels left offset 0.6,0 font ',11' textcolor rgb "
      "'#555555' notitle");
  script += fmt::format("plot {}\n", fmt::join(items, ", \\\n  "));
  return finished_picture(run_gnuplot(script).output, chart.title);
}

}  // namespace stepwire
