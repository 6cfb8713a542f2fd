#include "engine/analyse/kept/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/varied.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/signal_words.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::kept {
namespace {

/// Returns the numbers of an axis, ascending; an empty list for many numbers or for a formula.
std::vector<double> few_values(const diagram::Sweep::Axis& axis) {
  constexpr std::size_t few = 100;
  const diagram::SweptValues& all = axis.values;
  std::set<double> values;
  if (all.size() > few) return {};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto quantity = all.are_numbers() ? std::optional(unit::Quantity{all.number(i), {}})
                                            : unit::parse_quantity(all.text(i));
    if (!quantity) return {};
    values.insert(quantity->value);
  }
  return {values.begin(), values.end()};
}

/// Returns the unit after the first number in the text; empty without one.
std::string written_unit(const diagram::SweptValues& values) {
  if (values.empty()) return "";
  const std::string text = values.text(0);
  const auto quantity = unit::parse_quantity(text);
  double number = 0.0;
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  const char* rest = std::from_chars(text.data() + sign, text.data() + text.size(), number).ptr;
  while (*rest == ' ') ++rest;
  return quantity && quantity->dimension ? rest : "";
}

void add_swept_names(const run::Job& job, query::SymbolTable& names) {
  if (job.points.empty()) return;
  for (const diagram::Sweep::Axis& axis : job.plan.diagram.sweep->axes) {
    query::RecordedName name{axis.parameter, std::nullopt, std::nullopt};
    name.values = few_values(axis);
    name.unit = written_unit(axis.values);
    if (axis.label) name.words = run::words_of(axis);
    for (const diagram::DiagramParameter& parameter : job.plan.diagram.parameters) {
      if (parameter.name != axis.parameter) continue;
      name.dimension = parameter.dimension;
      if (!std::holds_alternative<double>(parameter.value.content))
        for (const std::string& word : run::words_of(axis)) name.words.push_back(without_quotes(word));
    }
    // The number of a block has the unit that its values have.
    if (!name.dimension && !axis.label) name.dimension = axis.values.dimension();
    names.columns.push_back(std::move(name));
  }
}

void add_signals(const diagram::Diagram& diagram, query::SymbolTable& names) {
  for (const diagram::DiagramBlock& block : diagram.blocks) {
    const auto& outputs = block.type().outputs;
    if (diagram::has_one_output(block.type())) names.signals.push_back(block.name);
    for (const OutputSpec& output : outputs) names.signals.push_back(block.name + "." + output.name);
  }
}

void add_outlines(const diagram::Diagram& diagram, query::SymbolTable& names) {
  for (const diagram::DiagramBlock& block : diagram.blocks) {
    if (!block.type().outline) continue;
    names.outlines.push_back({block.name, {}});
    block.type().outline(block.block.get(), names.outlines.back().outline);
  }
}

/// Returns a number of a block as expression text; empty if its unit depends on the wired signal.
std::string number_text(const ParameterSpec& spec, double value) {
  const auto unit = unit::parse_unit(spec.unit);
  if (!unit) return {};
  std::string name = unit->dimension == unit::Dimension{} ? "" : " " + unit::si_name(unit->dimension);
  std::replace(name.begin() + (name.empty() ? 0 : 1), name.end(), ' ', '.');
  return fmt::format("{}{}", value, name);
}

/// Set of names in use, recorded or not. It is a hash set because large diagrams have very many names.
using Taken = std::unordered_set<std::string_view>;

/// Adds a number of a block unless its name is in use.
void add_number(const std::string& name, const ParameterSpec& spec, double value, const Taken& taken,
                query::SymbolTable& names) {
  if (!std::isfinite(value) || taken.contains(name)) return;
  if (std::string text = number_text(spec, value); !text.empty())
    names.drawn.push_back({name, std::move(text)});
}

/// Adds the numbers of blocks, from the file, a preset or defaults: "rig.damper.beta"; elements of a list as
/// "rig.damper.alpha.2".
void add_numbers_of_blocks(const diagram::Diagram& diagram, query::SymbolTable& names) {
  Taken taken(names.signals.begin(), names.signals.end());
  for (const query::RecordedName& column : names.columns) taken.insert(column.name);
  for (const diagram::DiagramBlock& block : diagram.blocks)
    for (const ParameterSpec& spec : block.type().parameters) {
      const Value value = spec.get(block.block.get());
      const std::string name = block.name + "." + spec.name;
      if (const auto* number = std::get_if<double>(&value.content))
        add_number(name, spec, *number, taken, names);
      const auto* list = std::get_if<Eigen::VectorXd>(&value.content);
      if (list && list->size() == 1) add_number(name, spec, (*list)[0], taken, names);
      for (Eigen::Index k = 0; list && list->size() > 1 && k < list->size(); ++k)
        add_number(fmt::format("{}.{}", name, k + 1), spec, (*list)[k], taken, names);
    }
}

/// True for a formula of signals, in contrast to a word or a path.
bool is_formula(const std::string& text) {
  try {
    const expression::Expression formula(text);
    return !formula.variables().empty() && formula.variables().front() != text;
  } catch (const expression::ExpressionError&) {
    return false;
  }
}

/// Adds the words of recorded signals with enumerated values.
void add_words(const diagram::Diagram& diagram, query::SymbolTable& names) {
  std::unordered_map<std::string_view, std::vector<std::string>> words;
  for (const diagram::RecordRequest& record : diagram.records)
    for (const diagram::RecordedSignal& signal : record.signals)
      words.try_emplace(signal.name, diagram::signal_words(diagram, signal.signal));
  for (query::RecordedName& column : names.columns)
    if (const auto known = words.find(column.name); known != words.end()) column.words = known->second;
}

}  // namespace

std::string without_quotes(const std::string& word) {
  const bool quoted = word.size() > 1 && word.front() == '"' && word.back() == '"';
  try {
    return quoted ? yaml::parse_document(word, "a word").root.text : word;
  } catch (const yaml::Error&) {  // a word of a table, whose quotes are its own
    return word;
  }
}

query::SymbolTable names_of(const run::Job& job) {
  query::SymbolTable names = names_of_file(job);
  if (job.points.empty()) return names;
  query::VariedNames swept{{}, "swept"};
  for (const diagram::Sweep::Axis& axis : job.plan.diagram.sweep->axes)
    if (!axis.label) swept.names.push_back(axis.parameter);
  query::mark_varied(job.plan.diagram, swept, names);
  return names;
}

query::SymbolTable names_of_file(const run::Job& job) {
  const diagram::Diagram& diagram = job.plan.diagram;
  query::SymbolTable names{diagram.file, {}, {}};
  names.columns.push_back({"time", unit::parse_unit("s")->dimension, std::nullopt});
  add_swept_names(job, names);
  for (std::size_t r = 0; r < diagram.records.size(); ++r) {
    const auto columns = record::recorded_columns(job.plan, diagram.records[r]);
    for (std::size_t i = 1; i < columns.size(); ++i) {
      names.columns.push_back({columns[i].name, columns[i].dimension, r});
      names.columns.back().zeros_if_kelvin = columns[i].zeros_if_kelvin;
    }
  }
  add_words(diagram, names);
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    if (const double* number = std::get_if<double>(&parameter.value.content))
      names.parameters.push_back(
          {parameter.name, *number, parameter.dimension, query::unit_after_number(parameter.text)});
    else if (const std::string* text = parameter.value.text(); text && is_formula(*text))
      names.drawn.push_back({query::name_of_text(parameter.name), *text});
  add_signals(diagram, names);
  add_outlines(diagram, names);
  add_numbers_of_blocks(diagram, names);
  return names;
}

}  // namespace stepwire::kept
