#include "engine/analyse/query/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "engine/analyse/query/number.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::query {
namespace {

/// ExpressionError whose message may suggest a correct word.
struct FormulaError : expression::ExpressionError {
  FormulaError(yaml::Message message, std::size_t position)
      : expression::ExpressionError(message.text(), position), message(std::move(message)) {}
  yaml::Message message;
};

/// Throws FormulaError for a parameter or formula whose value differs from run to run.
void refuse_varied(const auto& named, std::size_t position) {
  if (!named.varies.empty()) throw FormulaError(named.varies, position);
}

/// Returns the column of words on the left of a comparison operator that ends at `end`; nullptr if there is
/// none.
const RecordedName* compared_column(std::string_view text, std::size_t end, const SymbolTable& names) {
  const auto last_of = [&](std::size_t behind) {
    while (behind > 0 && text[behind - 1] == ' ') --behind;
    return behind;
  };
  const std::size_t sign = last_of(end);
  if (sign < 2 || text[sign - 1] != '=' || (text[sign - 2] != '=' && text[sign - 2] != '!')) return nullptr;
  const std::size_t behind = last_of(sign - 2);
  std::size_t begin = behind;
  while (begin > 0 && (is_word(text[begin - 1]) || text[begin - 1] == '.')) --begin;
  const RecordedName* found = names.find(text.substr(begin, behind - begin));
  return found && !found->words.empty() ? found : nullptr;
}

/// Replaces the quoted word that starts at `begin` by its number. Returns the position after it.
std::size_t append_word(std::string_view text, std::size_t begin, const SymbolTable& names,
                        Substituted& result) {
  const std::size_t end = text.find(text[begin], begin + 1);
  if (end == std::string_view::npos)
    throw expression::ExpressionError("the word that begins here has no end", begin);
  const RecordedName* column = compared_column(text, begin, names);
  if (!column)
    throw expression::ExpressionError(
        "a word stands behind == or != and the name of a column of words: condition == \"V\"", begin);
  const std::string word(text.substr(begin + 1, end - begin - 1));
  const auto found = std::find(column->words.begin(), column->words.end(), word);
  if (found == column->words.end())
    throw FormulaError(fmt::format("'{}' is never '{}'", column->name, word) +
                           yaml::nearest_or_all(word, column->words, "there are"),
                       begin + 1);
  if (std::find(found + 1, column->words.end(), word) != column->words.end())
    throw expression::ExpressionError(fmt::format("several values of '{}' are '{}'", column->name, word),
                                      begin + 1);
  result.append(std::to_string(found - column->words.begin()), begin);
  return end + 1;
}

/// Replaces the name of a drawn formula or of a block's number that starts at `begin` by its expression.
/// Returns the position after it, or `begin` if there is no such name. Recorded columns of that name take
/// precedence.
std::size_t append_drawn(std::string_view text, std::size_t begin, const SymbolTable& names,
                         Substituted& result) {
  if (names.drawn.empty() || (begin > 0 && (is_word(text[begin - 1]) || text[begin - 1] == '.')))
    return begin;
  const std::string name = name_at(text, begin);
  const auto found = std::ranges::find(names.drawn, name, &NamedFormula::name);
  if (found == names.drawn.end() || names.find(name)) return begin;
  refuse_varied(*found, begin);
  result.append("(" + substitute(found->text, names).text + ")", begin);
  return begin + name.size();
}

const KnownParameter* parameter_of(const std::string& name, const SymbolTable& names) {
  const auto found = std::ranges::find(names.parameters, name, &KnownParameter::name);
  return found == names.parameters.end() ? nullptr : &*found;
}

/// Returns the formula that is the text of a parameter; nullptr for other parameters.
const NamedFormula* text_of(const std::string& name, const SymbolTable& names) {
  const auto found = std::ranges::find(names.drawn, name_of_text(name), &NamedFormula::name);
  return found == names.drawn.end() ? nullptr : &*found;
}

/// Returns the message for an unknown name after '$'.
yaml::Message unknown_parameter(const std::string& name, const SymbolTable& names) {
  std::vector<std::string> all;
  for (const auto& parameter : names.parameters) all.push_back(parameter.name);
  if (all.empty()) return fmt::format("there is no parameter '{}'; this diagram has none", name);
  return fmt::format("there is no parameter '{}'", name) + yaml::nearest_or_all(name, all, "there are");
}

/// Replaces the $name that starts at `begin` by its number, by its column if it varies (tuned parameters), or
/// by its text if that is a formula of signals. Returns the position after it.
std::size_t append_parameter(std::string_view text, std::size_t begin, const SymbolTable& names,
                             Substituted& result) {
  std::size_t end = begin + 1;
  while (end < text.size() && is_word(text[end])) ++end;
  const std::string name(text.substr(begin + 1, end - begin - 1));
  const KnownParameter* const found = parameter_of(name, names);
  const NamedFormula* const text_value = found || names.find(name) ? nullptr : text_of(name, names);
  if (!found && !names.find(name) && !text_value) throw FormulaError(unknown_parameter(name, names), begin);
  if (found) refuse_varied(*found, begin);
  if (text_value) refuse_varied(*text_value, begin);
  const std::string inserted = found        ? number_text(found->value, found->dimension, names)
                               : text_value ? text_value->text
                                            : name;
  result.append(fmt::format("({})", inserted), begin);
  return end;
}

/// Returns the position of the first whole occurrence of a name in a text, i.e. not inside another name.
std::size_t place_of(const std::string& name, std::string_view text) {
  std::size_t at = text.find(name);
  while (name_at(text, at) != name || (at > 0 && (is_word(text[at - 1]) || text[at - 1] == '.')))
    at = text.find(name, at + 1);
  return at;
}

/// Puts a "$" before each name that is a parameter, not a signal.
std::string with_marked_parameters(const std::string& text, const SymbolTable& names) {
  const expression::Expression expression(text);
  std::vector<std::string> others;
  for (const std::string& name : expression.variables())
    others.push_back(!names.find(name) && !names.lacks(name) && parameter_of(name, names) ? "$" + name
                                                                                          : name);
  return expression.renamed(others);
}

/// Replaces each name that is a parameter, not a signal, by its number.
Substituted with_parameters(const Substituted& text, const SymbolTable& names) {
  std::string marked;
  try {
    marked = with_marked_parameters(text.text, names);
  } catch (const expression::ExpressionError&) {
    return text;  // the parser reports the error
  }
  Substituted result;
  for (std::size_t i = 0, at = 0; at < marked.size();) {
    if (marked[at] != '$') {
      result.append(marked.substr(at++, 1), text.origin[i++]);
      continue;
    }
    const std::string name = name_at(marked, at + 1);
    const KnownParameter& parameter = *parameter_of(name, names);
    refuse_varied(parameter, text.origin[i]);
    result.append(fmt::format("({})", number_text(parameter.value, parameter.dimension, names)),
                  text.origin[i]);
    at += name.size() + 1;
    i += name.size();
  }
  return result;
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

/// True for a number made of ratios alone, without the functions that return angles.
bool is_ratio(const expression::Expression& expression, const std::optional<unit::Dimension>& dimension,
              const SymbolTable& names) {
  const auto& variables = expression.variables();
  const auto returns_angle = [&](const char* function) {
    return expression.text().find(function) != std::string::npos;
  };
  constexpr std::array angles{"asin", "acos", "atan"};
  return !variables.empty() && dimension == unit::Dimension{} && dimension->angle == 0.0 &&
         std::ranges::none_of(angles, returns_angle) &&
         std::ranges::all_of(variables, [&](const std::string& name) { return names.find(name)->is_ratio; });
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

yaml::Message unknown_column(const std::string& name, const SymbolTable& names) {
  std::vector<std::string> all;
  for (const auto& column : names.columns) all.push_back(column.name);
  const bool is_shown = name.starts_with("figure.") || name.starts_with("scene.");
  const auto beginning = [&](const std::string& of) {
    return of.substr(0, is_shown ? of.find('.') : of.rfind('.'));
  };
  for (const auto& drawn : names.drawn)
    if (beginning(drawn.name) == beginning(name)) all.push_back(drawn.name);
  if (!names.unknown.empty())
    return fmt::format("'{}' {}", name, names.unknown) + yaml::nearest_or_all(name, all, "there are");
  const bool is_vector = names.find(name + ".1") != nullptr;
  if (names.lacks(name) && !is_vector) return fmt::format("'{}' is not recorded; add it to 'record'", name);
  return fmt::format("'{}' is not recorded", name) + yaml::nearest_or_all(name, all, "recorded are");
}

std::string number_text(double value, const std::optional<unit::Dimension>& dimension,
                        const SymbolTable& names) {
  std::string number = fmt::format("{}", value);
  if (!dimension || *dimension == unit::Dimension{}) return number;
  std::string unit = unit::meaning_name(*dimension);
  std::replace(unit.begin(), unit.end(), ' ', '.');
  const auto known = [&](std::string_view name) { return names.find(name) != nullptr; };
  return unit::unit_prefix(unit, known) == unit.size() ? number + " " + unit : number;
}

std::string name_of_text(const std::string& parameter) {
  return "$" + parameter;
}

std::string name_at(std::string_view text, std::size_t position) {
  std::size_t end = position;
  while (end < text.size() && (is_word(text[end]) || text[end] == '.')) ++end;
  if (end == position || std::isdigit(static_cast<unsigned char>(text[position])) != 0) return {};
  return std::string(text.substr(position, end - position));
}

Substituted substitute(std::string_view text, const SymbolTable& names) {
  Substituted result;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t behind = append_drawn(text, i, names, result); behind > i) {
      i = behind;
      continue;
    }
    if (text[i] == '"' || text[i] == '\'') {
      i = append_word(text, i, names, result);
      continue;
    }
    if (text[i] != '$') {
      result.append(text.substr(i, 1), i);
      ++i;
      continue;
    }
    i = append_parameter(text, i, names, result);
  }
  return result;
}

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
    const bool ratio = is_ratio(expression, dimension, names);
    return Formula{trimmed(text), expression.strict(), std::move(columns), recording, dimension, mark, ratio};
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
  const std::size_t rows = recording.table.rows();
  const auto& variables = formula.expression.variables();
  if (variables.size() == 1 && formula.expression.text() == variables[0])
    return {columns[0], columns[0] + rows};
  std::vector<double> result(rows), values(columns.size());
  for (std::size_t row = 0; row < result.size(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) values[i] = columns[i][row];
    result[row] = formula.expression(values);
  }
  return result;
}

}  // namespace stepwire::query
