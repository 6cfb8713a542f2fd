#include "engine/view/plot/bar_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "engine/view/plot/figure_spec.hpp"

namespace stepwire::plot {
namespace {

constexpr double width = 680.0, row_height = 22.0, frame_height = 137.0;  // [pixels]
constexpr double half_bar = 0.36, group_gap = 0.6;                        // [rows]

/// Returns the centre of each bar, counted downwards in rows.
std::vector<double> places(const std::vector<Bar>& bars) {
  std::vector<double> result;
  double place = 0.0;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (i > 0 && bars[i].aside && !bars[i - 1].aside) place += group_gap;
    result.push_back(place);
    place += 1.0;
  }
  return result;
}

/// Returns the pieces of one kind.
RectanglesMark pieces(const BarChart& chart, const std::vector<double>& at, std::size_t kind) {
  RectanglesMark mark{.color = chart.kinds[kind].color, .legend = chart.kinds[kind].name};
  for (std::size_t i = 0; i < chart.bars.size(); ++i) {
    const auto& sizes = chart.bars[i].pieces;
    const double start =
        std::accumulate(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(kind), 0.0);
    mark.x_low.push_back(start);
    mark.x_high.push_back(start + sizes[kind]);
    mark.y_low.push_back(at[i] - half_bar);
    mark.y_high.push_back(at[i] + half_bar);
  }
  return mark;
}

double length(const Bar& bar) {
  return std::accumulate(bar.pieces.begin(), bar.pieces.end(), 0.0);
}

double longest(const std::vector<Bar>& bars) {
  double most = 0.0;
  for (const Bar& bar : bars) most = std::max(most, length(bar));
  return most > 0.0 ? most : 1.0;
}

/// Returns the axis of names, with the first bar on top.
PlotAxis names_of(const std::vector<Bar>& bars, const std::vector<double>& at) {
  PlotAxis axis{.range = {{(at.empty() ? 0.0 : at.back()) + 0.7, -0.7}},
                .line = false,
                .tick_marks = false,
                .grid = false};
  for (std::size_t i = 0; i < bars.size(); ++i) axis.named_ticks.push_back({at[i], bars[i].label});
  return axis;
}

/// Returns the text with the length of a bar at its end.
TextMark length_text(const Bar& bar, double at) {
  return {.text = fmt::format("{:.1f}", length(bar)),
          .x = length(bar),
          .y = at,
          .align = TextMark::Align::left,
          .offset = {0.6, 0.0},
          .size = 11.0,
          .color = "#555555"};
}

}  // namespace

FigureSpec figure_of(const BarChart& chart) {
  const auto at = places(chart.bars);
  Figure frame{.title = chart.title, .width = static_cast<int>(width)};
  frame.height = static_cast<int>(frame_height + row_height * ((at.empty() ? 0.0 : at.back()) + 1.0));
  FigureBuilder builder(std::move(frame), 1);
  PlotBuilder& plot = builder.add({});
  plot.spec.x.label = chart.axis;
  plot.spec.x.range = {0.0, 1.1 * longest(chart.bars)};
  plot.spec.y = names_of(chart.bars, at);
  for (std::size_t kind = 0; kind < chart.kinds.size(); ++kind) plot.add(pieces(chart, at, kind));
  for (std::size_t i = 0; i < chart.bars.size(); ++i)
    plot.spec.texts.push_back(length_text(chart.bars[i], at[i]));
  FigureSpec figure = builder.finished();
  std::get<PlotSpec>(figure.panels.front().content).legend = PlotSpec::Legend::above;
  return figure;
}

}  // namespace stepwire::plot
