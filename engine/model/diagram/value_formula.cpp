// Formulas of parameters: of single numbers, and of matrices.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/unit/meaning.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

std::string no_numbers(const std::string& name) {
  return fmt::format("'{}' is no number", name);
}

/// Returns numbers as a matrix, a list as its only column; std::nullopt for other values.
std::optional<Eigen::MatrixXd> matrix_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content))
    return Eigen::MatrixXd::Constant(1, 1, *number);
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) return *vector;
  const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content);
  return matrix ? std::optional(*matrix) : std::nullopt;
}

/// Returns the entry `value:` of {value: .., unit: ..}; nullptr if it is missing.
yaml::Entry* value_entry(yaml::Node& map) {
  for (yaml::Entry& entry : map.entries)
    if (entry.key == "value") return &entry;
  return nullptr;
}

/// True for a list with a number or a row of a matrix; its other items are then numbers as well.
bool is_of_numbers(const yaml::Node& list) {
  const auto is_number = [](const yaml::Node& item) {
    return item.is_list() || (item.is_scalar() && !item.quoted && unit::parse_quantity(item.text));
  };
  return std::ranges::any_of(list.items, is_number);
}

/// Returns the parameters that are single numbers.
std::vector<double> single_numbers(const std::vector<WrittenValue>& parameters) {
  std::vector<double> numbers;
  for (const WrittenValue& parameter : parameters)
    if (const double* number = std::get_if<double>(&parameter.value.content)) numbers.push_back(*number);
  return numbers;
}

std::vector<expression::Measure> measures_of(const std::vector<WrittenValue>& parameters) {
  std::vector<expression::Measure> measures;
  for (const WrittenValue& parameter : parameters)
    measures.push_back({parameter.dimension, parameter.dimension.has_value()});
  return measures;
}

/// Returns the dimension of a formula if it is sure. A sum or multiple of temperatures in degC keeps its own,
/// so that the reader of the value refuses it.
std::optional<unit::Dimension> dimension_of(const expression::Measure& measure) {
  const auto& dimension = measure.dimension;
  const bool is_known = measure.sure || (dimension && !unit::other_meaning(*dimension, *dimension).empty());
  return is_known ? dimension : std::nullopt;
}

/// Evaluates a formula of single numbers.
WrittenValue evaluated(const expression::Expression& expression, const std::vector<double>& values,
                       const std::vector<WrittenValue>& parameters, const std::string& text) {
  const expression::Measure measure = expression.measure(measures_of(parameters));
  expression.check_draws(std::vector<std::optional<double>>(values.begin(), values.end()));
  return {{expression(values)}, dimension_of(measure), text};
}

}  // namespace

std::optional<WrittenValue> ValueReader::read_expression(const yaml::Node& node,
                                                         const std::string& subject) const {
  try {
    const std::string text = node.text.substr(1);
    const expression::Expression* expression = parameters_.expression(text);
    std::vector<WrittenValue> of;
    for (const std::string& name :
         expression ? expression->variables() : parameters_.matrix_expression(text).variables()) {
      auto value = read_variable(name, node, subject);
      if (!value) return std::nullopt;
      of.push_back(std::move(*value));
    }
    const std::vector<double> values = single_numbers(of);
    if (!expression || values.size() < of.size()) return read_matrices(of, node, subject);
    WrittenValue result = evaluated(*expression, values, of, node.text);
    if (const double number = std::get<double>(result.value.content); !std::isfinite(number))
      return refuse(node, subject, fmt::format("'{}' is {}, not a finite number", node.text, number));
    return result;
  } catch (const expression::ExpressionError& error) {
    yaml::Mark mark = node.mark;  // the line of a setting is 0
    if (mark.line > 0) mark.column += 1 + (node.quoted ? 1 : 0) + static_cast<int>(error.position);
    report_.add(at(mark), subject, error.what());
    return std::nullopt;
  }
}

std::optional<WrittenValue> ValueReader::read_variable(const std::string& name, const yaml::Node& node,
                                                       const std::string& subject) const {
  std::string whole = name;
  const ElementIndex element = parameters_.defined(name) ? ElementIndex{} : take_element(whole);
  if (parameters_.failed(whole)) return std::nullopt;
  WrittenValue parameter = *parameters_.find(whole, uses_);
  const auto matrix = matrix_of(parameter.value);
  if (!matrix) return refuse_given(parameter) ? std::nullopt : refuse(node, subject, no_numbers(whole));
  if (element.is_whole()) return parameter;
  const bool by_column = element.column == 0 && matrix->cols() > 1 && matrix->rows() == 1;
  const Eigen::Index row = by_column ? 1 : element.row;
  const Eigen::Index column = by_column ? element.row : std::max<Eigen::Index>(element.column, 1);
  if (row > matrix->rows() || column > matrix->cols() ||
      (element.column == 0 && matrix->cols() > 1 && !by_column))
    return refuse(node, subject,
                  fmt::format("there is no '{}'; '{}' has {} x {} numbers", name, whole, matrix->rows(),
                              matrix->cols()));
  parameter.value.content = (*matrix)(row - 1, column - 1);
  return parameter;
}

std::optional<WrittenValue> ValueReader::read_matrices(const std::vector<WrittenValue>& values,
                                                       const yaml::Node& node,
                                                       const std::string& subject) const {
  const expression::MatrixExpression& expression = parameters_.matrix_expression(node.text.substr(1));
  std::vector<Eigen::MatrixXd> numbers;
  for (const WrittenValue& value : values) numbers.push_back(*matrix_of(value.value));
  const expression::Measure measure = expression.measure(measures_of(values));
  Eigen::MatrixXd result = expression(numbers);
  if (!result.allFinite())
    return refuse(node, subject, fmt::format("'{}' has numbers that are not finite", node.text));
  WrittenValue written{{result}, dimension_of(measure), node.text};
  if (result.size() == 1) written.value.content = result(0, 0);
  return written;
}

bool ValueReader::is_bare_formula(const yaml::Node& node, bool only_number) const {
  const std::string& text = node.text;
  // The text of a definition may be a formula of a block, where a name has another meaning.
  if (!only_number || !node.is_scalar() || text.empty() || text[0] == '=' ||
      text.find('$') != std::string::npos)
    return false;
  if (unit::parse_quantity(text) || means_not_finite(text)) return false;
  try {
    static_cast<void>(parameters_.matrix_expression(text));
    return true;
  } catch (const expression::ExpressionError&) {
    return false;
  }
}

yaml::Node ValueReader::with_formulas(const yaml::Node& node, bool only_numbers) const {
  yaml::Node result = node;
  if (is_bare_formula(node, only_numbers)) {
    result.text.insert(0, "=");
    result.mark.column -= result.mark.line > 0 ? 1 : 0;
  }
  const bool of_numbers = only_numbers || is_of_numbers(node);
  for (yaml::Node& item : result.items) item = with_formulas(item, of_numbers);
  if (yaml::Entry* value = result.is_map() ? value_entry(result) : nullptr)
    value->value = with_formulas(value->value, only_numbers);
  return result;
}

}  // namespace stepwire::diagram
