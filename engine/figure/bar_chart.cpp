#include "engine/figure/bar_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "engine/figure/gnuplot.hpp"
#include "engine/figure/picture.hpp"
#include "engine/figure/script.hpp"

namespace stepwire {
namespace {

constexpr double width = 680.0, row_height = 22.0, frame_height = 112.0;  // [pixels]
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
    list.push_back(fmt::format("{} {}", quoted(bars[i].label), at[i]));
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

double longest(const std::vector<Bar>& bars) {
  double most = 0.0;
  for (const Bar& bar : bars)
    most = std::max(most, std::accumulate(bar.pieces.begin(), bar.pieces.end(), 0.0));
  return most > 0.0 ? most : 1.0;
}

}  // namespace

std::string draw(const BarChart& chart) {
  const auto at = places(chart.bars);
  const double last = at.empty() ? 0.0 : at.back();
  std::string script = picture_terminal(width, frame_height + row_height * (last + 1.0)) + picture_style();
  script += fmt::format("set title {}\nset xlabel {}\n", quoted(chart.title), quoted(chart.axis));
  script += "set border 1\nset ytics scale 0 textcolor rgb '#111111'\nset grid noy\n";
  script +=
      "set key outside top center horizontal Left reverse samplen 1\nset style fill solid 1.0 noborder\n";
  script +=
      fmt::format("set xrange [0:{:.7g}]\nset yrange [{}:-0.7]\n", 1.05 * longest(chart.bars), last + 0.7);
  script += labels(chart.bars, at);
  std::vector<std::string> items;
  for (std::size_t kind = 0; kind < chart.kinds.size(); ++kind) {
    script += pieces(chart.bars, at, kind);
    items.push_back(fmt::format("$k{} using 1:3:1:2:($3-{}):($3+{}) with boxxyerror fc rgb '{}' title {}",
                                kind, half_bar, half_bar, curve_color(kind), quoted(chart.kinds[kind])));
  }
  script += fmt::format("plot {}\n", fmt::join(items, ", \\\n  "));
  return finished_picture(run_gnuplot(script).output, chart.title);
}

}  // namespace stepwire
