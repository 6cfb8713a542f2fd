#include "engine/analyse/query/varied.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "engine/model/diagram/own_value.hpp"
#include "engine/model/diagram/variation.hpp"

namespace stepwire::query {
namespace {

/// Returns the refusal of a name whose own value varies.
std::string own_value_text(const std::string& name, const std::string& how, const SymbolTable& names) {
  const std::string wrong =
      fmt::format("'{}' is {}, and the value of the file need not occur in any run", name, how);
  if (!names.find(name)) return wrong + "; record a signal that has it";
  return fmt::format("{}; write {}, its column (for a bound, compare a difference: 'x - {}' with 0)", wrong,
                     name, name);
}

/// A varied name and how it varies.
struct Cause {
  const std::string& name;
  const std::string& how;
};

/// Returns the refusal of a name that follows from another one by a formula, which may be empty.
std::string following_text(const std::string& name, const Cause& cause, const std::string& formula,
                           const SymbolTable& names) {
  const std::string wrong = fmt::format("'{}' follows from '{}', which is {}, so that it has no single value",
                                        name, cause.name, cause.how);
  if (names.find(name)) return fmt::format("{}; write {}, its column", wrong, name);
  const char* const column = names.find(cause.name) ? "the column " : "";
  return fmt::format("{}; record it, or write its formula with {}{}{}", wrong, column, cause.name,
                     formula.empty() ? "" : ": " + formula);
}

/// Returns the text of a parameter without the '=' of a formula.
std::string formula_of(const diagram::DiagramParameter& parameter) {
  const std::size_t begin = parameter.text.find_first_not_of("= ");
  return begin == std::string::npos ? "" : parameter.text.substr(begin);
}

void mark_parameter(const std::string& name, const std::string& text, SymbolTable& names) {
  for (KnownParameter& parameter : names.parameters)
    if (parameter.name == name && parameter.varies.empty()) parameter.varies = text;
  for (NamedFormula& formula : names.drawn)
    if (formula.name == name_of_text(name) && formula.varies.empty()) formula.varies = text;
}

/// Marks numbers of blocks by their refusals, and the elements of a list: "gain.k", "gain.k.2".
void mark_numbers(const std::unordered_map<std::string, std::string>& refusals, SymbolTable& names) {
  for (NamedFormula& formula : names.drawn) {
    auto found = refusals.find(formula.name);
    if (found == refusals.end()) found = refusals.find(formula.name.substr(0, formula.name.rfind('.')));
    if (found != refusals.end() && formula.varies.empty()) formula.varies = found->second;
  }
}

void mark_one(const diagram::Diagram& diagram, const std::string& name, const std::string& how,
              SymbolTable& names) {
  if (!diagram::find_name(diagram, name)) return;
  const diagram::Variation variation(diagram, {name});
  mark_parameter(name, own_value_text(name, how, names), names);
  for (const int index : variation.definitions()) {
    const diagram::DiagramParameter& parameter = diagram.parameters[static_cast<std::size_t>(index)];
    mark_parameter(parameter.name, following_text(parameter.name, {name, how}, formula_of(parameter), names),
                   names);
  }
  std::unordered_map<std::string, std::string> refusals;
  for (const diagram::Target& target : variation.targets()) {
    const std::string number = diagram::name_of(diagram, target);
    refusals[number] =
        number == name ? own_value_text(name, how, names) : following_text(number, {name, how}, "", names);
  }
  mark_numbers(refusals, names);
}

}  // namespace

void mark_varied(const diagram::Diagram& diagram, const VariedNames& varied, SymbolTable& names) {
  for (const std::string& name : varied.names) mark_one(diagram, name, varied.how, names);
}

}  // namespace stepwire::query
