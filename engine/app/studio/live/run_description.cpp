#include "engine/app/studio/live/run_description.hpp"

#include <algorithm>
#include <cmath>

#include "engine/model/diagram/bindings.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::live {

namespace {

using json::Json;

constexpr std::size_t most_numbers = 4000;  // of blocks, which a page can list
constexpr std::size_t most_traces = 6;      // of a scope that no figure gives

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

/// The ends of a slider: the bounds where there are any, else 0 and twice the value.
struct Ends {
  std::optional<double> low, high;

  Json add_to(Json json, double value) const {
    const double twice = value == 0.0 ? 1.0 : 2.0 * value;
    return json.set("low", low.value_or(std::min(value == 0.0 ? -1.0 : 0.0, twice)))
        .set("high", high.value_or(std::max(0.0, twice)));
  }
};

Ends ends_of(const diagram::Definition& definition) {
  Ends ends;
  for (const yaml::Entry& bound : definition.bounds) {
    const auto quantity = unit::parse_quantity(bound.value.text);
    if (!quantity) continue;
    (bound.key == "above" || bound.key == "at_least" ? ends.low : ends.high) = quantity->value;
  }
  return ends;
}

Ends ends_of(const Range& range) {
  return {range.at_least ? range.at_least : range.above, range.at_most ? range.at_most : range.below};
}

void add_parameters(const diagram::Diagram& diagram, Json& list) {
  for (std::size_t i = 0; i < diagram.parameters.size(); ++i) {
    const diagram::DiagramParameter& parameter = diagram.parameters[i];
    const double* value = std::get_if<double>(&parameter.value.content);
    if (!value) continue;
    Json json = Json::object()
                    .set("name", parameter.name)
                    .set("text", parameter.text)
                    .set("value", *value)
                    .set("unit", unit_text(parameter.dimension));
    json = ends_of(diagram.bindings->definitions[i]).add_to(std::move(json), *value);
    list.push(json.set("doc", parameter.doc).set("block", false));
  }
}

std::string unit_of(const diagram::DiagramBlock& block, std::size_t parameter) {
  const auto& written = block.parameter_dimensions;
  if (parameter < written.size() && written[parameter]) return unit_text(*written[parameter]);
  const auto unit = unit::parse_unit(block.type().parameters[parameter].unit);
  return unit ? unit_text(unit->dimension) : "";
}

/// The number of a block's parameter; nothing where it is something else, or a list of several.
std::optional<double> number_of(const ParameterSpec& spec, const void* block) {
  const bool is_number = spec.kind == ParameterKind::number || spec.kind == ParameterKind::per_element;
  if (!is_number || !spec.get) return std::nullopt;
  const Value value = spec.get(block);
  if (const double* number = std::get_if<double>(&value.content)) return *number;
  const auto* list = std::get_if<Eigen::VectorXd>(&value.content);
  return list && list->size() == 1 ? std::optional((*list)[0]) : std::nullopt;
}

void add_numbers_of(const diagram::DiagramBlock& block, Json& list) {
  for (std::size_t p = 0; p < block.type().parameters.size(); ++p) {
    const ParameterSpec& spec = block.type().parameters[p];
    const std::optional<double> number = number_of(spec, block.block.get());
    if (!number || !std::isfinite(*number)) continue;
    Json json = Json::object()
                    .set("name", block.name + "." + spec.name)
                    .set("text", fmt::format("{} {}", *number, unit_of(block, p)))
                    .set("value", *number)
                    .set("unit", unit_of(block, p));
    json = ends_of(spec.range).add_to(std::move(json), *number);
    list.push(json.set("doc", spec.doc).set("block", true));
  }
}

Json parameters_json(const diagram::Diagram& diagram) {
  Json list = Json::list();
  add_parameters(diagram, list);
  for (const diagram::DiagramBlock& block : diagram.blocks)
    if (list.items().size() < most_numbers) add_numbers_of(block, list);
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

/// The curves of a panel over time; what is drawn of several runs side by side has none of one run.
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
    } catch (const std::exception&) {  // reads what a run alone does not have, such as what a sweep varies
    }
  }
  return traces;
}

/// Scopes of what is recorded, for a file without such figures: one for each unit.
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
      .set("parameters", parameters_json(diagram))
      .set("scopes", scopes_json(run))
      .set("inputs", inputs_json(run.plan()))
      .set("scene", run.model().scene != nullptr)
      .set("figures", run.model().figures.size())
      .set("claims", std::move(claims));
}

}  // namespace stepwire::live
