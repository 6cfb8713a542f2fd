#include "engine/analyse/query/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/analyse/query/formula_error.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/substituted.hpp"

namespace stepwire::query {
namespace {

/// Returns the position of the first whole occurrence of a name in a text, i.e. not inside another name.
std::size_t place_of(const std::string& name, std::string_view text) {
  std::size_t at = text.find(name);
  while (name_at(text, at) != name || (at > 0 && (is_word(text[at - 1]) || text[at - 1] == '.')))
    at = text.find(name, at + 1);
  return at;
}

expression::Expression parse(std::string_view text, const SymbolTable& names) {
  const Substituted substituted = with_parameters(substitute(text, names), names);
  try {
    // A signal "e" or "pi" that is not recorded must not be read as the constant.
    expression::Expression expression(substituted.text, [&](std::string_view name) {
      return names.find(name) != nullptr || ((name == "e" || name == "pi") && names.lacks(name));
    });
    for (const std::string& name : expression.variables())
      if (names.lacks(name))
        throw FormulaError(unknown_column(name, names), place_of(name, substituted.text));
    return expression;
  } catch (const expression::ExpressionError& error) {
    const std::size_t position = substituted.origin_of(error.position);
    const std::string name = name_at(text, position);
    const std::size_t behind = text.find_first_not_of(' ', position + name.size());
    const bool function = behind != std::string_view::npos && text[behind] == '(';
    const bool unknown = !name.empty() && !function && names.find(name) == nullptr &&
                         std::string_view(error.what()).find(name) != std::string_view::npos;
    if (unknown) throw FormulaError(unknown_column(name, names), position);
    throw expression::ExpressionError(error.what(), position);
  }
}

/// Returns the dimension of an expression. Throws ExpressionError for mismatched units, with the position in
/// the original text.
std::optional<unit::Dimension> find_dimension(const expression::Expression& expression, std::string_view text,
                                              const SymbolTable& names) {
  std::vector<expression::Measure> measures;
  for (const auto& name : expression.variables()) {
    const auto& dimension = names.find(name)->dimension;
    measures.push_back({dimension, dimension.has_value()});
  }
  try {
    return expression.measure(measures).dimension;
  } catch (const expression::ExpressionError& error) {
    throw expression::ExpressionError(
        error.what(), with_parameters(substitute(text, names), names).origin_of(error.position));
  }
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// Returns the recording that has all variables. Returns std::nullopt if they are in different recordings,
/// whose names are added to `apart`.
std::optional<std::size_t> recording_of(const std::vector<std::string>& variables, const SymbolTable& names,
                                        std::vector<std::string>& apart) {
  std::optional<std::size_t> recording;
  std::string first;
  for (const auto& variable : variables) {
    const auto& wanted = names.find(variable)->recording;
    if (!wanted) continue;
    if (recording && *recording != *wanted) apart = {first, variable};
    if (!recording) first = variable;
    recording = recording.value_or(*wanted);
  }
  return recording;
}

std::string apart_message(const std::vector<std::string>& apart, const SymbolTable& names) {
  if (!names.unknown.empty())
    return fmt::format(
        "'{}' and '{}' are of different tables, numbers of all runs and rows of some; use them apart",
        apart.front(), apart.back());
  return fmt::format(
      "'{}' and '{}' are recorded at different periods; record them in one entry to use them together",
      apart.front(), apart.back());
}

}  // namespace

yaml::Place place_in(const yaml::Node& node, std::size_t offset, const SymbolTable& names) {
  yaml::Place place{names.file, node.mark};
  place.mark.column += static_cast<int>(offset) + (node.quoted ? 1 : 0);
  return place;
}

std::optional<Formula> read_formula(const yaml::Node& node, const SymbolTable& names,
                                    const std::string& subject, yaml::Faults& faults) {
  if (!node.is_scalar()) {
    faults.add({{names.file, node.mark}, subject, "an expression is wanted here, such as 'abs(rig.x)'", {}});
    return std::nullopt;
  }
  return read_formula(node, node.text, 0, names, subject, faults);
}

std::optional<Formula> read_formula(const yaml::Node& node, std::string_view text, std::size_t offset,
                                    const SymbolTable& names, const std::string& subject,
                                    yaml::Faults& faults) {
  if (text.starts_with('=') && !text.starts_with("=="))
    return read_formula(node, text.substr(1), offset + 1, names, subject, faults);
  try {
    expression::Expression expression = parse(text, names);
    const auto& variables = expression.variables();
    std::vector<std::string> columns, apart;
    for (const auto& variable : variables) {
      const RecordedName& known = *names.find(variable);
      columns.push_back(known.column.empty() ? known.name : known.column);
    }
    const auto recording = recording_of(variables, names, apart);
    if (!apart.empty()) {
      faults.add({place_in(node, offset, names), subject, apart_message(apart, names), {}});
      return std::nullopt;
    }
    const auto dimension = find_dimension(expression, text, names);
    const yaml::Mark mark = place_in(node, offset, names).mark;
    return Formula{trimmed(text), std::move(expression), std::move(columns), recording, dimension, mark};
  } catch (const FormulaError& error) {
    faults.add({place_in(node, offset + error.position, names), subject, error.message, {}});
  } catch (const expression::ExpressionError& error) {
    faults.add({place_in(node, offset + error.position, names), subject, error.what(), {}});
  }
  return std::nullopt;
}

std::size_t common_recording(const std::vector<const Formula*>& formulas, const SymbolTable& names,
                             const yaml::Node& at, const std::string& subject, yaml::Faults& faults) {
  std::vector<std::string> variables, apart;
  for (const Formula* formula : formulas) {
    if (formula == nullptr) continue;
    const auto& used = formula->expression.variables();
    variables.insert(variables.end(), used.begin(), used.end());
  }
  const auto recording = recording_of(variables, names, apart);
  if (!apart.empty()) faults.add({{names.file, at.mark}, subject, apart_message(apart, names), {}});
  return recording.value_or(0);
}

std::vector<double> evaluate(const Formula& formula, const record::Recording& recording) {
  std::vector<const double*> columns;
  for (const auto& name : formula.columns) {
    const table::Column* column = recording.table.find(name);
    if (column == nullptr) throw std::invalid_argument(fmt::format("'{}' was not recorded", name));
    columns.push_back(column->values.data());
  }
  std::vector<double> result(recording.table.rows()), values(columns.size());
  for (std::size_t row = 0; row < result.size(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) values[i] = columns[i][row];
    result[row] = formula.expression(values);
  }
  return result;
}

}  // namespace stepwire::query
