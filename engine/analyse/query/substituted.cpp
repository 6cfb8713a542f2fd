#include "engine/analyse/query/substituted.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/formula_error.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::query {
namespace {

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
  const std::string inserted = found        ? number_text(found->value, found->dimension, names)
                               : text_value ? text_value->text
                                            : name;
  result.append(fmt::format("({})", inserted), begin);
  return end;
}

}  // namespace

std::string number_text(double value, const std::optional<unit::Dimension>& dimension,
                        const SymbolTable& names) {
  std::string number = fmt::format("{}", value);
  if (!dimension || *dimension == unit::Dimension{}) return number;
  std::string unit = unit::si_name(*dimension);
  if (unit::is_temperature(*dimension) && dimension->zeros)
    unit = *dimension->zeros > 0.5 ? "temperature_K" : "delta_degC";
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

Substituted with_parameters(const Substituted& text, const SymbolTable& names) {
  std::string marked;
  try {
    const expression::Expression expression(text.text);
    std::vector<std::string> others;
    for (const std::string& name : expression.variables())
      others.push_back(!names.find(name) && !names.lacks(name) && parameter_of(name, names) ? "$" + name
                                                                                            : name);
    marked = expression.renamed(others);
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
    result.append(fmt::format("({})", number_text(parameter.value, parameter.dimension, names)),
                  text.origin[i]);
    at += name.size() + 1;
    i += name.size();
  }
  return result;
}

}  // namespace stepwire::query
