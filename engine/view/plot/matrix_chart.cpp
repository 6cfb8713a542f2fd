#include "engine/view/plot/matrix_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/view/plot/figure_spec.hpp"

namespace stepwire::plot {
namespace {

constexpr double cell = 44.0, letter_width = 7.2, head = 44.0, bar = 90.0;  // [px]
constexpr std::size_t max_with_numbers = 16;

/// Returns cells as coloured rectangles: the known ones, or the others in grey.
RectanglesMark cells(const MatrixChart& chart, bool known) {
  RectanglesMark mark{.color = known ? "" : "#cccccc"};
  for (std::size_t row = 0; row < chart.values.size(); ++row)
    for (std::size_t column = 0; column < chart.values[row].size(); ++column) {
      const double value = chart.values[row][column], x = static_cast<double>(column),
                   y = static_cast<double>(row);
      if (std::isfinite(value) != known) continue;
      mark.x_low.push_back(x - 0.5);
      mark.x_high.push_back(x + 0.5);
      mark.y_low.push_back(y - 0.5);
      mark.y_high.push_back(y + 0.5);
      if (known) mark.value.push_back(value);
    }
  return mark;
}

/// Returns the numbers of cells, bright on dark ones.
std::vector<TextMark> numbers(const RectanglesMark& cells) {
  std::vector<TextMark> texts;
  for (std::size_t i = 0; i < cells.value.size(); ++i) {
    const double value = cells.value[i];
    texts.push_back({.text = fmt::format("{:.2f}", std::abs(value) < 0.005 ? 0.0 : value),
                     .x = cells.x_low[i] + 0.5,
                     .y = cells.y_low[i] + 0.5,
                     .size = 10.0,
                     .color = std::abs(value) > 0.75 ? "#ffffff" : "#222222"});
  }
  return texts;
}

PlotAxis names_of(const MatrixChart& chart, bool across) {
  const double last = static_cast<double>(std::max<std::size_t>(1, chart.names.size())) - 0.5;
  PlotAxis axis{.range = {{across ? -0.5 : last, across ? last : -0.5}},
                .label_angle = across ? 45.0 : 0.0,
                .tick_marks = false,
                .grid = false};
  for (std::size_t i = 0; i < chart.names.size(); ++i)
    axis.named_ticks.push_back({static_cast<double>(i), chart.names[i]});
  return axis;
}

/// Returns the space for the names left of the cells and below them [px].
double margin_of(const MatrixChart& chart) {
  std::size_t longest = 1;
  for (const std::string& name : chart.names) longest = std::max(longest, name.size());
  return 20.0 + letter_width * static_cast<double>(longest);
}

double side_of(const MatrixChart& chart) {
  return cell * static_cast<double>(std::max<std::size_t>(1, chart.names.size()));
}

Figure picture_of(const MatrixChart& chart) {
  const double side = side_of(chart), margin = margin_of(chart);
  return {.title = chart.title,
          .width = static_cast<int>(std::max(360.0, margin + side + bar)),
          .height = static_cast<int>(head + side + margin)};
}

}  // namespace

FigureSpec figure_of(const MatrixChart& chart) {
  FigureBuilder figure(picture_of(chart), 1);
  PlotBuilder& plot = figure.add({});
  plot.spec.frame = std::array{margin_of(chart), head, side_of(chart), side_of(chart)};
  plot.spec.x = names_of(chart, true);
  plot.spec.y = names_of(chart, false);
  plot.spec.color = PlotAxis{.range = {{-1.0, 1.0}}, .step = 0.5};
  plot.spec.palette = {
      {0.0, "#2166ac"}, {0.25, "#92c5de"}, {0.5, "#ffffff"}, {0.75, "#f4a582"}, {1.0, "#b2182b"}};
  const RectanglesMark known = cells(chart, true);
  RectanglesMark unknown = cells(chart, false);
  if (!known.value.empty()) plot.add(known);
  if (!unknown.x_low.empty()) plot.add(std::move(unknown));
  if (chart.names.size() <= max_with_numbers) plot.spec.texts = numbers(known);
  return figure.finished();
}

}  // namespace stepwire::plot
