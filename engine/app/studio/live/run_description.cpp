#include "engine/app/studio/live/run_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/model/diagram/bindings.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::live {

namespace {

using json::Json;

constexpr std::size_t most_numbers = 4000;  // numbers of blocks that a page can list
constexpr double around_zero = 10.0;        // half range of the slider for 0 in a unit that is not SI

/// Unit for the display of a number: shown = SI * scale + offset.
struct ShownUnit {
  std::string text;
  double scale = 1.0, offset = 0.0;

  double shown(double value) const { return value * scale + offset; }
  double si(double shown) const { return (shown - offset) / scale; }
  Json json() const { return Json::object().set("text", text).set("scale", scale).set("offset", offset); }
};

bool is_near(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// Returns the text after the number of a quantity: "mm" for "10 mm".
std::string_view unit_behind_number(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t+"), text.size()));
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [behind, wrong] = std::from_chars(text.data(), end, number);
  const std::string_view rest(behind, static_cast<std::size_t>(end - behind));
  const std::size_t first = rest.find_first_not_of(" \t"), last = rest.find_last_not_of(" \t");
  if (wrong != std::errc() || first == std::string_view::npos) return {};
  return rest.substr(first, last - first + 1);
}

/// Returns the unit of a text such as "10 mm" whose number equals an SI value; std::nullopt for other texts.
std::optional<ShownUnit> unit_of_text(std::string_view text, double value) {
  const auto quantity = unit::parse_quantity(text);
  const std::string_view behind = unit_behind_number(text);
  const auto unit = unit::parse_unit(behind);
  if (!quantity || behind.empty() || !unit) return std::nullopt;
  ShownUnit shown{std::string(behind)};
  shown.scale = unit->from_si(1.0) - unit->from_si(0.0);
  if (is_near(quantity->value, value)) {
    shown.offset = unit->from_si(0.0);
    return shown;
  }
  const double without_offset = quantity->value - unit->to_si(0.0);  // a temperature difference
  return is_near(without_offset, value) ? std::optional(shown) : std::nullopt;
}

/// Range of a slider in SI: the bounds if any, else from 0 to twice the displayed value.
struct Ends {
  std::optional<double> low, high;

  Json add_to(Json json, double value, const ShownUnit& unit) const {
    const double shown = unit.shown(value), twice = shown == 0.0 ? reach(unit) : 2.0 * shown;
    const double least = unit.si(shown == 0.0 ? -twice : std::min(0.0, twice));
    return json.set("low", low.value_or(least)).set("high", high.value_or(unit.si(std::max(0.0, twice))));
  }
  static double reach(const ShownUnit& unit) {
    return unit.scale == 1.0 && unit.offset == 0.0 ? 1.0 : around_zero;
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

/// Texts of the scalars in a file, by line and column.
using Texts = std::map<std::pair<int, int>, std::string>;

void gather(const yaml::Node& node, Texts& texts) {
  if (node.is_scalar()) texts.emplace(std::pair(node.mark.line, node.mark.column), node.text);
  for (const yaml::Node& item : node.items) gather(item, texts);
  for (const yaml::Entry& entry : node.entries) gather(entry.value, texts);
}

/// Returns the number of a block's parameter; std::nullopt for another type and for a list of several
/// numbers.
std::optional<double> number_of(const ParameterSpec& spec, const void* block) {
  const bool is_number = spec.kind == ParameterKind::number || spec.kind == ParameterKind::per_element;
  if (!is_number || !spec.get) return std::nullopt;
  const Value value = spec.get(block);
  if (const double* number = std::get_if<double>(&value.content)) return *number;
  const auto* list = std::get_if<Eigen::VectorXd>(&value.content);
  return list && list->size() == 1 ? std::optional((*list)[0]) : std::nullopt;
}

/// Returns a declared unit, "'u", without the word for differences.
std::string declared_unit(const std::string& unit) {
  const std::string differences = "delta ";
  return unit.starts_with(differences) ? unit.substr(differences.size()) : unit;
}

/// Returns the SI unit of a block's number: that of the file, of the declaration, or of an output that is
/// declared with the same unit.
std::string si_unit(const plan::Plan& plan, int index, std::size_t parameter) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(index)];
  const auto& written = block.parameter_dimensions;
  if (parameter < written.size() && written[parameter]) return unit_text(*written[parameter]);
  const std::string declared = declared_unit(block.type().parameters[parameter].unit);
  if (const auto unit = unit::parse_unit(declared)) return unit_text(unit->dimension);
  for (std::size_t o = 0; o < block.type().outputs.size(); ++o)
    if (block.type().outputs[o].unit == declared)
      return unit_text(plan.dimension({index, static_cast<int>(o), -1}));
  return "";
}

class ParameterList {
 public:
  explicit ParameterList(const LoadedRun& run) : run_(run), diagram_(run.plan().diagram) {
    for (std::size_t i = 0; i < diagram_.parameters.size(); ++i) has_slider_.push_back(is_number(i));
    for (const diagram::Binding& binding : diagram_.bindings->bindings)
      if (binding.target.kind == diagram::Target::Kind::parameter && all_have_sliders(binding.uses))
        bound_.emplace(binding.target.block, binding.target.index);
  }

  Json json() {
    for (std::size_t i = 0; i < diagram_.parameters.size(); ++i) add_parameter(i);
    for (std::size_t b = 0; b < diagram_.blocks.size() && list_.items().size() < most_numbers; ++b)
      add_numbers_of(static_cast<int>(b));
    return std::move(list_);
  }

 private:
  bool all_have_sliders(const diagram::ParameterUses& uses) const {
    return !uses.empty() && std::ranges::all_of(uses, [&](int use) { return has_slider(use); });
  }
  bool has_slider(int parameter) const { return has_slider_[static_cast<std::size_t>(parameter)]; }

  /// True for a number that sliders can set: its own, or those of the parameters in its expression.
  bool is_number(std::size_t i) const {
    return std::holds_alternative<double>(diagram_.parameters[i].value.content);
  }

  /// True for a text that consists of parameters with sliders; a quantity whose bounds use names is none.
  bool is_expression(std::size_t i) const {
    return all_have_sliders(diagram_.bindings->definitions[i].uses) &&
           !unit::parse_quantity(diagram_.parameters[i].text);
  }

  void add_parameter(std::size_t i) {
    const diagram::DiagramParameter& parameter = diagram_.parameters[i];
    const double* value = std::get_if<double>(&parameter.value.content);
    if (!value || is_expression(i) || !names_.insert(parameter.name).second) return;
    const std::string si = unit_text(parameter.dimension);
    const ShownUnit unit = unit_of_text(parameter.text, *value).value_or(ShownUnit{si});
    Json json = described(parameter.name, parameter.text, *value, si, unit);
    json = ends_of(diagram_.bindings->definitions[i]).add_to(std::move(json), *value, unit);
    list_.push(json.set("doc", parameter.doc).set("block", false));
  }

  void add_numbers_of(int index) {
    const diagram::DiagramBlock& block = diagram_.blocks[static_cast<std::size_t>(index)];
    for (std::size_t p = 0; p < block.type().parameters.size(); ++p) {
      const ParameterSpec& spec = block.type().parameters[p];
      const std::optional<double> value = number_of(spec, block.block.get());
      const std::string name = block.name + "." + spec.name;
      if (!value || !std::isfinite(*value) || bound_.contains({index, static_cast<int>(p)})) continue;
      if (!names_.insert(name).second) continue;
      const std::string si = si_unit(run_.plan(), index, p);
      const std::string* written = text_of(block, p);
      const auto unit = written ? unit_of_text(*written, *value) : std::nullopt;
      const auto others = !written || *value == 0.0 ? unit_of_others(block, p) : std::nullopt;
      const ShownUnit shown = unit ? *unit : others.value_or(ShownUnit{si});
      const std::string text = unit ? *written : fmt::format("{} {}", shown.shown(*value), shown.text);
      Json json = described(name, text, *value, si, shown);
      json = ends_of(spec.range).add_to(std::move(json), *value, shown);
      list_.push(json.set("doc", spec.doc).set("block", true));
    }
  }

  /// Returns the unit in which the file writes another number of the block that has the same declared unit.
  std::optional<ShownUnit> unit_of_others(const diagram::DiagramBlock& block, std::size_t parameter) {
    const auto& all = block.type().parameters;
    if (all[parameter].unit == "1") return std::nullopt;
    for (std::size_t p = 0; p < all.size(); ++p) {
      const auto value = number_of(all[p], block.block.get());
      const std::string* written = text_of(block, p);
      if (p == parameter || !value || !written) continue;
      if (declared_unit(all[p].unit) != declared_unit(all[parameter].unit)) continue;
      if (const auto unit = unit_of_text(*written, *value); unit && unit->offset == 0.0) return unit;
    }
    return std::nullopt;
  }

  static Json described(const std::string& name, const std::string& text, double value, const std::string& si,
                        const ShownUnit& unit) {
    return Json::object()
        .set("name", name)
        .set("text", text)
        .set("value", value)
        .set("unit", si)
        .set("shown", unit.json());
  }

  /// Returns the text of a block's parameter in its file; nullptr for a default.
  const std::string* text_of(const diagram::DiagramBlock& block, std::size_t parameter) {
    const yaml::Mark mark = block.parameter_marks[parameter];
    if (mark.line == 0) return nullptr;
    const std::string& file = diagram_.scopes[static_cast<std::size_t>(block.origin.scope)].file;
    const auto [known, is_new] = texts_.try_emplace(file);
    const yaml::Document* document = is_new ? run_.document(file) : nullptr;
    if (document) gather(document->root, known->second);
    const auto text = known->second.find({mark.line, mark.column});
    return text == known->second.end() ? nullptr : &text->second;
  }

  const LoadedRun& run_;
  const diagram::Diagram& diagram_;
  std::vector<bool> has_slider_;         ///< for each parameter
  std::set<std::pair<int, int>> bound_;  ///< blocks and their parameters that depend on others
  std::set<std::string> names_;          ///< names in the list
  std::map<std::string, Texts> texts_;   ///< texts of each file
  Json list_ = Json::list();
};

/// Returns the independent parameters of a run and the numbers of its blocks; values that follow from other
/// parameters are omitted. Each has its value in SI and the unit in which its file writes it.
Json parameters_json(const LoadedRun& run) {
  return ParameterList(run).json();
}

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
