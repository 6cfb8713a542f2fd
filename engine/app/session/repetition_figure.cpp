#include "engine/app/session/repetition_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::session {

namespace {

bool is_probability(const std::string& name) {
  return name.starts_with("p.");
}

/// Adds a histogram with a line at the published value. The number of bins grows with the number of
/// experiments.
void draw_value(const study::Distribution& one, plot::FigureBuilder& figure) {
  const bool p = is_probability(one.name);
  std::vector<double> values = one.values;
  const double bins = std::clamp(std::floor(1.5 * std::sqrt(static_cast<double>(values.size()))), 6.0, 40.0);
  if (p)
    for (double& value : values) value = std::log10(value);
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  plot::Panel panel{.title = "", .bins = bins};
  if (!std::isnan(one.published)) {
    panel.title = fmt::format("published: {:.3g}", one.published);
    panel.lines = {p ? std::log10(one.published) : one.published};
  }
  plot::PlotBuilder& plot = figure.add(panel);
  plot::name_axis(plot.spec.x, p ? "log10 of P, " + one.name.substr(2) : one.name, "1");
  plot::draw_histogram(values, plot);
}

}  // namespace

plot::FigureSpec repetition_figure(const std::vector<study::ExperimentOutcome>& experiments,
                                   const study::StudyRequest& request) {
  std::vector<study::Distribution> known = study::distributions_of_errors(experiments, request);
  std::ranges::move(study::distributions_of_p(experiments, request), std::back_inserter(known));
  plot::FigureBuilder figure(
      {.title = fmt::format("Task {}: {} experiments with simulated operators, and what is published",
                            request.task, experiments.size()),
       .columns = 2},
      known.size());
  for (const study::Distribution& one : known) draw_value(one, figure);
  return figure.finished();
}

}  // namespace stepwire::session
