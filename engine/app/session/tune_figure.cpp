// Figure of an optimisation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/app/session/tuning.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::session {

namespace {

constexpr std::size_t most_panels = 12;

/// Returns the indices of the evaluations that are feasible and the best so far.
std::vector<std::size_t> improvements(const tuning::TuneResult& result) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < result.history.size(); ++i) {
    const tuning::Evaluation& one = result.history[i];
    if (one.is_feasible() && (found.empty() || one.objective < result.history[found.back()].objective))
      found.push_back(i);
  }
  return found;
}

/// Returns a step curve: each value holds until the next improvement, the last one to the end.
template <class Value>
plot::NumberCurve steps_of(const tuning::TuneResult& result, const std::vector<std::size_t>& at, Value value,
                           const std::string& legend) {
  plot::NumberCurve curve{{}, {}, legend};
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::size_t end = k + 1 < at.size() ? at[k + 1] : result.history.size() - 1;
    for (const std::size_t x : {at[k], std::max(at[k], end)}) {
      curve.x.push_back(static_cast<double>(x + 1));
      curve.y.push_back(value(result.history[at[k]]));
    }
  }
  return curve;
}

/// True if all values are positive and the largest exceeds ten times the smallest.
bool spans_decades(const std::vector<double>& values) {
  if (values.empty()) return false;
  const auto [low, high] = std::ranges::minmax_element(values);
  return *low > 0.0 && *high > 10.0 * *low;
}

void finish_panel(plot::PlotBuilder& plot, const tuning::TuneResult& result) {
  plot::name_axis(plot.spec.x, "evaluation", "");
  plot::set_line_ranges(plot);
  plot.spec.x.range = {{1.0, std::max(2.0, static_cast<double>(result.history.size()))}};
}

void add_objective(const LoadedModel& model, const tuning::TuneResult& result,
                   const std::vector<std::size_t>& better, plot::FigureBuilder& panels) {
  plot::NumberCurve all{{}, {}, "each evaluation"};
  for (std::size_t i = 0; i < result.history.size(); ++i) {
    if (result.history[i].is_bad()) continue;
    all.x.push_back(static_cast<double>(i + 1));
    all.y.push_back(result.history[i].objective);
  }
  plot::PlotBuilder& plot = panels.add({.y = {.log = spans_decades(all.y)}});
  const auto& dimension = result.dimension;
  plot::name_axis(plot.spec.y,
                  model.tune->objective_text().size() <= 40 ? model.tune->objective_text() : "objective",
                  dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "");
  std::vector<plot::NumberCurve> curves{std::move(all)};
  if (!better.empty())
    curves.push_back(steps_of(
        result, better, [](const tuning::Evaluation& one) { return one.objective; }, "best with all claims"));
  plot::draw_curves(curves, plot);
  finish_panel(plot, result);
}

void add_number(const tuning::TuneResult& result, std::size_t number, const std::vector<std::size_t>& better,
                plot::FigureBuilder& panels) {
  const tuning::TunedNumber& of = result.numbers[number];
  const unit::Unit unit = unit::parse_unit(of.unit).value_or(unit::Unit{});
  plot::NumberCurve curve = steps_of(
      result, better, [&](const tuning::Evaluation& one) { return unit.from_si(one.values[number]); }, "");
  plot::PlotBuilder& plot = panels.add({.y = {.log = spans_decades(curve.y)}});
  const bool si = of.unit.empty() && of.dimension && *of.dimension != unit::Dimension{};
  plot::name_axis(plot.spec.y, of.name, si ? unit::si_name(*of.dimension) : of.unit);
  plot::draw_curves({std::move(curve)}, plot);
  finish_panel(plot, result);
}

}  // namespace

plot::FigureSpec tune_figure(const LoadedModel& model, const tuning::TuneResult& result) {
  const std::vector<std::size_t> better = improvements(result);
  const std::size_t numbers = better.empty() ? 0 : std::min(result.numbers.size(), most_panels - 1);
  plot::FigureBuilder panels({.title = "Tuning, evaluation by evaluation", .columns = numbers > 3 ? 2 : 1},
                             numbers + 1);
  add_objective(model, result, better, panels);
  for (std::size_t i = 0; i < numbers; ++i) add_number(result, i, better, panels);
  return panels.finished();
}

}  // namespace stepwire::session
