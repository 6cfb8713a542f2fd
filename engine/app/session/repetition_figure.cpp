#include "engine/app/session/repetition_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire {

namespace {

bool is_probability(const std::string& name) {
  return name.starts_with("p.");
}

/// Its panel with a line at the thesis' value. The more experiments, the finer its bins.
void draw_value(const NamedValue& published, std::vector<double> values, FigureBuilder& figure) {
  const bool p = is_probability(published.name);
  const double bins = std::clamp(std::floor(1.5 * std::sqrt(static_cast<double>(values.size()))), 6.0, 40.0);
  if (p)
    for (double& value : values) value = std::log10(value);
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  Panel panel{.title = "", .bins = bins};
  if (!std::isnan(published.value)) {
    panel.title = fmt::format("thesis: {:.3g}", published.value);
    panel.lines = {p ? std::log10(published.value) : published.value};
  }
  PlotBuilder& plot = figure.add(panel);
  name_axis(plot.spec.x, p ? "log10 of P, " + published.name.substr(2) : published.name, "1");
  draw_histogram(values, plot);
}

}  // namespace

FigureSpec repetition_figure(const Repetition& repetition, const StudyRequest& request) {
  std::vector<NamedValue> known = published_outcome(request);
  std::erase_if(known, [&](const NamedValue& value) {
    return std::ranges::count(repetition.columns(), value.name) == 0;
  });
  FigureBuilder figure(
      {.title = fmt::format("Task {}: {} experiments with simulated operators, and the thesis'", request.task,
                            repetition.size()),
       .columns = 2},
      known.size());
  for (const NamedValue& value : known) draw_value(value, repetition.column(value.name), figure);
  return figure.finished();
}

}  // namespace stepwire
