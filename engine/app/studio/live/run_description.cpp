#include "engine/app/studio/live/run_description.hpp"

#include <algorithm>
#include <cmath>

#include "engine/app/studio/live/parameter_list.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::live {

namespace {

using json::Json;

constexpr std::size_t most_traces = 6;  // per default scope

Json columns_json(const SignalList& signals) {
  Json list = Json::list();
  for (std::size_t i = 0; i < signals.all().size(); ++i) {
    const LiveSignal& signal = signals.all()[i];
    list.push(Json::object()
                  .set("column", i)
                  .set("name", signal.name)
                  .set("unit", unit_text(signal.dimension))
                  .set("recorded", signal.recorded));
  }
  return list;
}

Json trace_json(LoadedRun& run, const std::string& expression, const std::string& label) {
  const std::size_t index = run.find(expression);
  const LiveColumn column = run.column(index);
  return Json::object()
      .set("column", index)
      .set("source", expression)
      .set("label", label)
      .set("unit", column.unit)
      .set("scale", column.scale)
      .set("offset", column.offset);
}

std::string expression_of(const query::Series& series) {
  const std::string& text = series.formula.text;
  return series.unit_text.empty() ? text : text + " in " + series.unit_text;
}

/// Returns the curves of a panel over time; empty for a panel over several runs.
Json scope_of(LoadedRun& run, const plot::Panel& panel) {
  Json traces = Json::list();
  const query::Series* x = panel.find("x");
  const auto curves = panel.series.find("y");
  if (!x || x->formula.text != "time" || curves == panel.series.end()) return traces;
  for (std::size_t i = 0; i < curves->second.size(); ++i) {
    const query::Series& series = curves->second[i];
    const bool named = i < panel.legend.size() && curves->second.size() == panel.legend.size();
    try {
      traces.push(trace_json(run, expression_of(series), named ? panel.legend[i] : series.label));
    } catch (const std::exception&) {  // the formula reads swept values, which a single run does not have
    }
  }
  return traces;
}

/// Returns default scopes for a file without figures: one for each unit of its records.
Json recorded_scopes(LoadedRun& run) {
  std::map<std::string, Json> by_unit;
  for (const LiveSignal& signal : run.signals().all()) {
    if (!signal.recorded) continue;
    Json& traces = by_unit[unit_text(signal.dimension)];
    if (traces.items().size() < most_traces) traces.push(trace_json(run, signal.name, signal.name));
  }
  Json scopes = Json::list();
  for (auto& [unit, traces] : by_unit)
    scopes.push(
        Json::object().set("title", unit.empty() ? "signals" : unit).set("traces", std::move(traces)));
  return scopes;
}

Json scopes_json(LoadedRun& run) {
  Json scopes = Json::list();
  for (const plot::Figure& figure : run.model().figures)
    for (const plot::Panel& panel : figure.panels) {
      Json traces = scope_of(run, panel);
      if (traces.items().empty()) continue;
      const std::string title = panel.title.empty() ? panel.y.label : panel.title;
      scopes.push(
          Json::object().set("title", title.empty() ? figure.title : title).set("traces", std::move(traces)));
    }
  return scopes.items().empty() ? recorded_scopes(run) : scopes;
}

Json inputs_json(const plan::Plan& plan) {
  Json list = Json::list();
  for (const diagram::DiagramInput& input : plan.diagram.inputs) {
    const diagram::SignalRef signal{input.block, 0, -1};
    list.push(Json::object()
                  .set("name", input.name)
                  .set("size", plan.slot(signal).size)
                  .set("unit", unit_text(plan.dimension(signal)))
                  .set("low", nullptr)
                  .set("high", nullptr)
                  .set("doc", input.doc));
  }
  return list;
}

}  // namespace

Json run_description(LoadedRun& run) {
  const diagram::Diagram& diagram = run.plan().diagram;
  Json claims = Json::list();
  for (const claim::Claim& claim : run.model().claims) claims.push(Json::object().set("that", claim.that));
  return Json::object()
      .set("run", run.thread().status().run)
      .set("title", diagram.title)
      .set("step", diagram.step)
      .set("stop", std::isfinite(diagram.stop) ? Json(diagram.stop) : Json())
      .set("columns", columns_json(run.signals()))
      .set("parameters", parameters_json(run))
      .set("scopes", scopes_json(run))
      .set("inputs", inputs_json(run.plan()))
      .set("scene", run.model().scene != nullptr)
      .set("figures", run.model().figures.size())
      .set("claims", std::move(claims));
}

}  // namespace stepwire::live
