#include "engine/simulate/codegen/value_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/simulate/codegen/literals.hpp"

namespace stepwire::codegen {

namespace {

NumberText constant(double value) {
  const std::string text = number_text(value);
  return {text.starts_with('-') ? "(" + text + ")" : text, value, false};
}

bool keeps_numbers(const unit::Unit& unit) {
  return unit.scale == 1.0L && unit.offset == 0.0L;
}

}  // namespace

std::vector<double> numbers_of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value.content)) return {*number};
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    return {vector->begin(), vector->end()};
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    return {matrix->data(), matrix->data() + matrix->size()};
  return {};
}

std::string element_text(const std::string& name, const Value& value, std::size_t k) {
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content)) {
    const auto rows = static_cast<std::size_t>(matrix->rows());
    return fmt::format("{}[{}][{}]", name, k % rows, k / rows);
  }
  return std::holds_alternative<double>(value.content) ? name : fmt::format("{}[{}]", name, k);
}

std::vector<NumberText> ValueTexts::parameter(std::size_t d) const {
  const Value& value = diagram_.parameters[d].value;
  const std::string name = name_(d);
  const std::vector<double> numbers = stepwire::codegen::numbers_of(value);
  std::vector<NumberText> texts;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    texts.push_back(name.empty() ? constant(numbers[k])
                                 : NumberText{element_text(name, value, k), std::nullopt, false});
  return texts;
}

ValueTexts::Numbers ValueTexts::numbers(const yaml::Node& node, int scope) const {
  if (node.is_map()) return with_unit(node, scope);
  if (node.is_list()) return list(node, scope);
  return node.is_scalar() ? scalar(node, scope) : std::nullopt;
}

ValueTexts::Numbers ValueTexts::with_unit(const yaml::Node& node, int scope) const {
  const yaml::Node* value = node.find("value");
  const yaml::Node* unit_node = node.find("unit");
  auto numbers = value ? this->numbers(*value, scope) : std::nullopt;
  if (!numbers || !unit_node) return numbers;
  const auto unit = unit::parse_unit(unit_node->text);
  if (!unit) return std::nullopt;
  if (keeps_numbers(*unit)) return numbers;
  for (NumberText& number : *numbers) {
    if (!number.constant) return std::nullopt;
    number = constant(unit->to_si(*number.constant));
  }
  return numbers;
}

ValueTexts::Numbers ValueTexts::list(const yaml::Node& node, int scope) const {
  if (!node.items.empty() && node.items.front().is_list()) return rows(node, scope);
  std::vector<NumberText> all;
  for (const yaml::Node& item : node.items) {
    const auto one = item.is_scalar() ? scalar(item, scope) : std::nullopt;
    if (!one || one->size() != 1) return std::nullopt;
    all.push_back(one->front());
  }
  return all;
}

ValueTexts::Numbers ValueTexts::rows(const yaml::Node& node, int scope) const {
  std::vector<std::vector<NumberText>> rows;
  for (const yaml::Node& item : node.items) {
    auto row = item.is_list() ? list(item, scope) : std::nullopt;
    if (!row || (!rows.empty() && row->size() != rows.front().size())) return std::nullopt;
    rows.push_back(std::move(*row));
  }
  std::vector<NumberText> by_column;
  for (std::size_t column = 0; column < rows.front().size(); ++column)
    for (const auto& row : rows) by_column.push_back(row[column]);
  return by_column;
}

ValueTexts::Numbers ValueTexts::scalar(const yaml::Node& node, int scope) const {
  if (node.quoted && !node.text.starts_with('=')) return std::nullopt;
  if (node.text.starts_with('$')) return named(node.text.substr(1), scope);
  if (node.text.starts_with('=')) return expression(node.text.substr(1), scope);
  const auto quantity = unit::parse_quantity(node.text);
  return quantity ? Numbers{{constant(quantity->value)}} : std::nullopt;
}

ValueTexts::Numbers ValueTexts::named(const std::string& name, int scope) const {
  const auto& definitions = diagram_.bindings->definitions;
  for (std::size_t d = 0; d < definitions.size(); ++d)
    if (definitions[d].scope == scope && definitions[d].name == name) return parameter(d);
  const Value* value = diagram_.bindings->scopes[static_cast<std::size_t>(scope)].value(name);
  if (!value) return std::nullopt;
  std::vector<NumberText> texts;
  for (const double number : stepwire::codegen::numbers_of(*value)) texts.push_back(constant(number));
  return texts;
}

/// Returns the numbers of `K` or `-K`; all other matrix formulas are computed by the loader only.
ValueTexts::Numbers ValueTexts::of_matrices(std::string text, int scope) const {
  std::erase(text, ' ');
  if (!text.starts_with('-')) return named(text, scope);
  auto numbers = named(text.substr(1), scope);
  if (numbers)
    for (NumberText& number : *numbers)
      number = number.constant ? constant(-*number.constant)
                               : NumberText{"(-" + number.text + ")", std::nullopt, number.computed};
  return numbers;
}

ValueTexts::Numbers ValueTexts::expression(const std::string& text, int scope) const {
  const diagram::ParameterScope& of_file = diagram_.bindings->scopes[static_cast<std::size_t>(scope)];
  const expression::Expression* known = of_file.expression(text);
  if (!known) return std::nullopt;
  const expression::Expression& expression = *known;
  std::vector<std::string> variables;
  std::vector<double> constants;
  for (const std::string& name : expression.variables()) {
    const auto value = named(name, scope);
    if (value && value->size() != 1) return of_matrices(text, scope);
    if (!value) return std::nullopt;
    variables.push_back(value->front().text);
    if (value->front().constant) constants.push_back(*value->front().constant);
  }
  if (constants.size() == variables.size()) return {{constant(expression(constants))}};
  const auto variable = [&](std::size_t i) { return variables[i]; };
  return {{NumberText{"(" + expression.cpp(variable) + ")", std::nullopt, true}}};
}

}  // namespace stepwire::codegen
