#include "engine/app/report/run_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "engine/analyse/query/number.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/count.hpp"
#include "engine/base/unit/meaning.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/bare_number.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/plan/element_slot.hpp"

namespace stepwire::report {
namespace {

std::string verdict_line(const claim::Verdict& verdict) {
  return fmt::format("  {} {}: {} ({}){}{}\n",
                     verdict.surprises() || verdict.fails() ? "FAIL"
                     : verdict.holds                        ? "ok  "
                                                            : "note",
                     text::visible(verdict.that), text::visible(verdict.shown), text::visible(verdict.check),
                     verdict.note.empty() ? "" : "; " + text::visible(verdict.note),
                     verdict.disagrees.empty()
                         ? ""
                         : fmt::format("; {}: {}", verdict.word(), text::visible(verdict.disagrees)));
}

/// Unit of a value, or those of its elements where these are in several.
struct UnitOfValue {
  std::optional<unit::Dimension> dimension;
  diagram::EachUnit each{};
};

/// True for a number, a list or a formula without any unit: "2e-3", "[1, 2]", "3*2".
bool is_bare(const std::string& setting) {
  if (const auto quantity = unit::parse_quantity(setting)) return !quantity->dimension;
  return setting.find_first_not_of("0123456789eE+-*/^.,[]() ") == std::string::npos;
}

/// Returns a line for each number without unit in a list: "k.2 = 3 m".
std::string lines_of_elements(const std::string& name, const yaml::Node& list, const UnitOfValue& unit) {
  std::string lines;
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const auto dimension = k < unit.each.size() ? unit.each[k] : unit.dimension;
    if (diagram::is_bare(list.items[k]) && dimension && *dimension != unit::Dimension{})
      lines += fmt::format("  set  {}.{} = {} {}\n", text::visible(name), k + 1, list.items[k].text,
                           unit::si_name(*dimension));
  }
  return lines;
}

/// Returns the line of a setting without unit, which is taken in SI; "" for other settings.
std::string setting_line(const std::string& name, const std::string& setting, const UnitOfValue& unit) {
  const auto& dimension = unit.dimension;
  if (setting.starts_with('[') && (!is_bare(setting) || !unit.each.empty()))
    return lines_of_elements(name, yaml::parse_document(setting, name).root, unit);
  if (!is_bare(setting) || !dimension || *dimension == unit::Dimension{}) return "";
  const auto quantity = unit::parse_quantity(setting);
  if (quantity && quantity->value == 0.0 && !unit::is_temperature(*dimension)) return "";
  return fmt::format("  set  {} = {} {}\n", text::visible(name),
                     quantity ? query::short_number(quantity->value) : text::visible(setting),
                     unit::si_name(*dimension));
}

/// Returns the unit of a block's own value, "rig.spring.gain".
UnitOfValue unit_of_value(const diagram::Diagram& diagram, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {};
  const auto has_name = [&](const diagram::DiagramBlock& block) { return block.name == name.substr(0, dot); };
  const auto block = std::ranges::find_if(diagram.blocks, has_name);
  if (block == diagram.blocks.end()) return {};
  const BlockType& type = block->type();
  const std::string key = name.substr(dot + 1);
  if (const int state = diagram::state_of_key(type, key); state >= 0)
    return {diagram.state_dimensions[static_cast<std::size_t>(block - diagram.blocks.begin())]
                                    [static_cast<std::size_t>(state)]};
  const ParameterSpec* parameter = type.parameter(key);
  if (!parameter) return {};
  const auto index = static_cast<std::size_t>(parameter - type.parameters.data());
  if (const diagram::EachUnit* each = block->elements_of(index)) return {{}, *each};
  const auto& written = block->parameter_dimensions[index];
  return {written ? written : diagram::demanded_dimension(*parameter)};
}

/// Returns a line for each value that a call sets by a number without unit. Later settings replace earlier
/// ones of the same name.
std::string settings_text(const session::LoadedModel& model) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  std::string text;
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    if (parameter.set)
      text += setting_line(parameter.name, parameter.text, {parameter.dimension, parameter.each});
  std::map<std::string, std::string> of_blocks;
  for (const diagram::Setting& setting : model.options.settings) of_blocks[setting.name] = setting.value;
  for (const auto& [name, value] : of_blocks) text += setting_line(name, value, unit_of_value(diagram, name));
  return text;
}

}  // namespace

/// Returns the unit of an output, or those of its elements: "m, rad, not known".
static std::string units_of(const diagram::Diagram& diagram, std::size_t block, std::size_t output) {
  const auto name = [](const std::optional<unit::Dimension>& dimension) {
    return dimension ? unit::si_name(*dimension) : std::string("not known");
  };
  for (const diagram::ElementDimensions& one : diagram.element_dimensions) {
    if (one.block != static_cast<int>(block) || one.output != static_cast<int>(output)) continue;
    std::vector<std::string> names;
    for (const auto& dimension : one.each) names.push_back(name(dimension));
    return fmt::format("{}", fmt::join(names, ", "));
  }
  return name(diagram.output_dimensions[block][output]);
}

std::string outcome_text(const session::LoadedModel& model, const session::Outcome& outcome) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const std::size_t runs = std::max<std::size_t>(1, model.job.points.size());
  std::string text = fmt::format("{}\n  {}: {}, {}{}, {:.3g} s\n",
                                 text::visible(diagram.title.empty() ? model.file : diagram.title),
                                 text::visible(model.file), text::counted(diagram.blocks.size(), "block"),
                                 runs > 1 ? fmt::format("{} runs, ", runs) : "",
                                 text::counted(outcome.result.ticks, "tick"), outcome.seconds) +
                     settings_text(model);
  std::size_t held = 0;
  for (const claim::Verdict& verdict : outcome.verdicts) {
    if (verdict.kind == claim::Claim::Kind::invariant && verdict.holds)
      ++held;
    else
      text += verdict_line(verdict);
  }
  for (const query::NamedTable& table : model.tables)
    if (table.name == session::sensitivity_table && !outcome.early()) text += text::text(*table.table);
  if (held > 0)
    text += fmt::format("  ok   held throughout: {} {}\n", held, held == 1 ? "invariant" : "invariants");
  for (const run::RaisedDiagnostic& diagnostic : outcome.result.diagnostics)
    text += fmt::format("  note {}: {} (first at {:.6g} s)\n", text::visible(diagnostic.block),
                        text::visible(diagnostic.text), diagnostic.time);
  for (const std::string& finding : session::findings_of(model, outcome))
    text += fmt::format("  note {}\n", text::visible(finding));
  return text;
}

std::string failures_text(const session::Outcome& outcome, const std::string& file) {
  std::string text;
  for (const claim::Verdict& verdict : outcome.verdicts)
    if (verdict.surprises() || verdict.fails()) text += verdict_line(verdict);
  return text.empty() ? "" : fmt::format("{}\n{}", text::visible(file), text);
}

std::string units_text(const plan::Plan& plan) {
  const diagram::Diagram& diagram = plan.diagram;
  std::string text;
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = diagram.blocks[b];
    for (std::size_t o = 0; o < block.type().outputs.size(); ++o) {
      const std::string port = diagram::output_name(block.name, block.type(), o);
      const plan::SignalSlot& slot = plan.blocks[b].outputs[o];
      const std::string shape =
          slot.size == 1 ? "" : fmt::format(" ({})", plan::shape_text(slot.size, slot.columns));
      text += fmt::format("  {:<40} {}{}\n", text::visible(port), units_of(diagram, b, o), shape);
    }
  }
  return text;
}

}  // namespace stepwire::report
