#include "engine/view/plot/figure_spec.hpp"

#include <algorithm>
#include <numeric>

#include "engine/view/plot/overlay_drawing.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "engine/view/plot/run_numbers.hpp"
#include "engine/view/plot/ticks.hpp"

namespace stepwire::plot {
namespace {

constexpr double title_height = 34.0;  // [px]

/// Returns the width of each panel [px].
double panel_width(const Figure& figure) {
  if (figure.width > 0) return static_cast<double>(figure.width) / figure.columns;
  return figure.columns == 1 ? 680.0 : figure.columns == 2 ? 520.0 : 400.0;
}

/// True if the panels have aligned axes; false if one of them has a legend beside it.
bool has_aligned_axes(const Figure& figure, const std::vector<PanelSpec>& panels) {
  return figure.columns == 1 && panels.size() > 1 && std::ranges::all_of(panels, [](const PanelSpec& panel) {
           const auto& plot = std::get<PlotSpec>(panel.content);
           return plot.legend != PlotSpec::Legend::beside && !plot.view;
         });
}

}  // namespace

FigureBuilder::FigureBuilder(Figure figure, std::size_t count)
    : figure_(std::move(figure)), width_(panel_width(figure_)), share_(1.0 / static_cast<double>(count)) {}

PlotBuilder& FigureBuilder::add(Panel panel) {
  panels_.push_back(std::move(panel));
  return plots_.emplace_back(panels_.back(), width_, share_);
}

/// Returns the heights of the rows of panels, each that of its highest panel.
std::vector<double> FigureBuilder::row_heights(double head) const {
  const auto columns = static_cast<std::size_t>(figure_.columns);
  std::vector<double> heights((plots_.size() + columns - 1) / columns, 0.0);
  for (std::size_t i = 0; i < plots_.size(); ++i)
    heights[i / columns] = std::max(heights[i / columns], plots_[i].suitable_height());
  const double all = std::accumulate(heights.begin(), heights.end(), 0.0);
  if (figure_.height > 0)
    for (double& height : heights) height *= (figure_.height - head) / all;
  return heights;
}

FigureSpec FigureBuilder::finished() {
  const double head = figure_.title.empty() ? 0.0 : title_height;
  const std::vector<double> heights = row_heights(head);
  FigureSpec spec{figure_.title, width_ * figure_.columns, head};
  const auto columns = static_cast<std::size_t>(figure_.columns);
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    const double height = heights[i / columns];
    PlotSpec plot = plots_[i].finished();
    set_steps(plot, axes_size(plot, width_, height));
    spec.panels.push_back(
        {width_ * static_cast<double>(i % columns), spec.height, width_, height, std::move(plot)});
    if ((i + 1) % columns == 0 || i + 1 == plots_.size()) spec.height += height;
  }
  spec.aligned = has_aligned_axes(figure_, spec.panels);
  return spec;
}

/// Returns a panel that reads the one recording of its numbers and draws all rows.
static Panel panel_of_numbers(Panel panel) {
  panel.recordings = {0};
  panel.where.reset();
  return panel;
}

FigureSpec figure_spec(const Figure& figure, std::span<const record::Recording> recordings) {
  if (!figure.panels.empty() && figure.panels.front().content)
    return {figure.title, 0.0, 0.0, false, {{0.0, 0.0, 0.0, 0.0, figure.panels.front().content(recordings)}}};
  FigureBuilder builder(figure, figure.panels.size());
  for (const Panel& panel : figure.panels) {
    const bool reduces = !panel.numbers.empty();
    PlotBuilder& plot = builder.add(reduces ? panel_of_numbers(panel) : panel);
    cover_overlays(panel, recordings, plot);
    if (reduces) {
      const record::Recording numbers = numbers_of_runs(panel, recordings);
      panel.kind->draw(plot.panel(), {&numbers, 1}, plot);
    } else {
      panel.kind->draw(panel, recordings, plot);
    }
    plot.judge_marks();
    draw_overlays(panel, recordings, plot);
  }
  return builder.finished();
}

}  // namespace stepwire::plot
