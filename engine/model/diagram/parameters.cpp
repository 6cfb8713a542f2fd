// More than 300 lines with its header: values, lists, expressions and inserted texts are read by each
// other, and by the kind of what they are for.
#include "engine/model/diagram/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/quoted_number.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

yaml::Message no_parameter(const std::string& name, const ParameterScope& parameters) {
  return fmt::format("there is no parameter '{}'", name) + yaml::did_you_mean(name, parameters.names());
}

std::string no_numbers(const std::string& name) {
  return fmt::format("'{}' is no number", name);
}

/// Numbers as a matrix, a list as its only column; nothing for other values.
std::optional<Eigen::MatrixXd> matrix_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content))
    return Eigen::MatrixXd::Constant(1, 1, *number);
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) return *vector;
  const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content);
  return matrix ? std::optional(*matrix) : std::nullopt;
}

/// What stands behind `value:` in {value: .., unit: ..}.
yaml::Entry* value_entry(yaml::Node& map) {
  for (yaml::Entry& entry : map.entries)
    if (entry.key == "value") return &entry;
  return nullptr;
}

/// The letters, digits and underscores from here on.
std::string word_at(const std::string& text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
    ++end;
  return text.substr(begin, end - begin);
}

/// A number or a word as it stands inside of a text; nothing for any other value.
std::optional<std::string> inserted_text(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content))
    return *number < 0 ? fmt::format("({})", *number) : fmt::format("{}", *number);
  return value.text() ? std::optional(*value.text()) : std::nullopt;
}

}  // namespace

const WrittenValue* ParameterScope::find(const std::string& name, ParameterUses* uses) const {
  const auto found = values_.find(name);
  if (found == values_.end()) return nullptr;
  const Entry& entry = found->second;
  entry.used = true;
  if (uses && entry.index >= 0)
    uses->push_back(entry.index);
  else
    entry.structural = true;
  return &entry.value;
}

void ParameterScope::define(const std::string& name, WrittenValue value, int index) {
  values_[name] = {std::move(value), index};
}

WrittenValue ParameterScope::replace(const std::string& name, WrittenValue value) {
  return std::exchange(values_.at(name).value, std::move(value));
}

const Value* ParameterScope::value(const std::string& name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second.value.value;
}

bool ParameterScope::failed(const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() && found->second.value.failed;
}

bool ParameterScope::used(const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() && found->second.used;
}

bool ParameterScope::is_structural(const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() && found->second.structural;
}

std::vector<std::string> ParameterScope::names() const {
  std::vector<std::string> result;
  for (const auto& [name, entry] : values_) result.push_back(name);
  return result;
}

bool ParameterScope::knows(const std::string& name) const {
  std::string whole = name;
  return defined(name) || (!take_element(whole).is_whole() && defined(whole));
}

const expression::Expression* ParameterScope::expression(const std::string& text) const {
  const auto known = [this](std::string_view name) { return knows(std::string(name)); };
  const auto [found, is_new] = expressions_.try_emplace(text);
  if (!is_new) return found->second ? &*found->second : nullptr;
  try {
    found->second.emplace(text, known);
  } catch (const expression::ExpressionError&) {
    expressions_.erase(found);
    matrix_expression(text);  // throws where it is none of both
    expressions_.try_emplace(text);
    return nullptr;
  }
  return &*found->second;
}

const expression::MatrixExpression& ParameterScope::matrix_expression(const std::string& text) const {
  const auto found = matrix_expressions_.find(text);
  if (found != matrix_expressions_.end()) return found->second;
  const auto known = [this](std::string_view name) { return knows(std::string(name)); };
  return matrix_expressions_.emplace(text, expression::MatrixExpression(text, known)).first->second;
}

std::string unit_complaint(const std::optional<unit::Dimension>& written,
                           const std::optional<unit::Dimension>& demanded) {
  if (!written || !demanded || *written == *demanded) return "";
  if (*demanded == unit::Dimension{})
    return fmt::format("is in {}; it must be a pure number, without a unit", unit::si_name(*written));
  return fmt::format("is in {}; it must be in {}", unit::si_name(*written), unit::si_name(*demanded));
}

bool means_not_finite(const std::string& text) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::size_t dot = text.substr(sign).starts_with('.') ? 1 : 0;
  const char* begin = text.c_str() + sign + dot;
  if (text.size() == sign + dot || (dot == 1 && !std::isalpha(static_cast<unsigned char>(*begin))))
    return false;
  char* end = nullptr;
  return !std::isfinite(std::strtod(begin, &end)) && *end == '\0';
}

std::nullopt_t ValueReader::refuse(const yaml::Node& node, const std::string& subject,
                                   yaml::Message message) const {
  report_.add(at(node.mark), subject, std::move(message));
  return std::nullopt;
}

bool ValueReader::refuse_given(const WrittenValue& written) const {
  if (!written.given || !written.value.text()) return false;
  report_.add(written.given->origin, written.given->name,
              unit::parse_quantity(written.text)
                  ? quoted_number(written.text)
                  : yaml::fault_text("'{}' is no number; write one, as 2{}, and '=' before what is computed",
                                     written.text, written.given->unit));
  return true;
}

std::optional<WrittenValue> ValueReader::read(const yaml::Node& written, const std::string& subject) const {
  const yaml::Node node = with_formulas(written, false);
  if (node.is_map()) return read_with_unit(node, subject);
  if (node.is_list()) return read_list(node, subject);
  if (node.is_scalar()) return read_scalar(node, subject);
  return refuse(node, subject, "has no value");
}

std::optional<WrittenValue> ValueReader::read_scalar(const yaml::Node& node,
                                                     const std::string& subject) const {
  const std::string& text = node.text;
  // An expression with a comma, a colon or a quotation mark in it needs quotes around it.
  if (node.quoted && !text.starts_with('=')) return WrittenValue{{text}, {}, text};
  if (text.starts_with('$')) {
    if (parameters_.failed(text.substr(1))) return std::nullopt;
    if (const WrittenValue* parameter = parameters_.find(text.substr(1), uses_)) return *parameter;
    return refuse(node, subject, no_parameter(text.substr(1), parameters_));
  }
  if (text.starts_with('=')) return read_expression(node, subject);
  if (const auto quantity = unit::parse_quantity(text))
    return WrittenValue{{quantity->value}, quantity->dimension, text};
  if (means_not_finite(text))
    return refuse(node, subject,
                  yaml::fault_text("'{}' is not a finite number; give one, or leave the key out", text));
  if (text == "true" || text == "false") return WrittenValue{{text == "true"}, {}, text};
  const auto filled = fill_in(node, subject);  // a path such as data/$name.csv
  return filled ? std::optional(WrittenValue{{*filled}, {}, *filled}) : std::nullopt;
}

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
    std::vector<double> values;
    std::vector<expression::Measure> measures;
    for (const WrittenValue& parameter : of) {
      if (const double* number = std::get_if<double>(&parameter.value.content)) values.push_back(*number);
      measures.push_back({parameter.dimension, parameter.dimension.has_value()});
    }
    if (!expression || values.size() < of.size()) return read_matrices(of, node, subject);
    const expression::Measure measure = expression->measure(measures);
    expression->check_draws(std::vector<std::optional<double>>(values.begin(), values.end()));
    const double result = (*expression)(values);
    if (!std::isfinite(result))
      return refuse(node, subject, fmt::format("'{}' is {}, not a finite number", node.text, result));
    return WrittenValue{{result}, measure.sure ? measure.dimension : std::nullopt, node.text};
  } catch (const expression::ExpressionError& error) {
    yaml::Mark mark = node.mark;  // of a setting there is none
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
  std::vector<expression::Measure> measures;
  for (const WrittenValue& value : values) {
    numbers.push_back(*matrix_of(value.value));
    measures.push_back({value.dimension, value.dimension.has_value()});
  }
  const expression::Measure measure = expression.measure(measures);
  Eigen::MatrixXd result = expression(numbers);
  if (!result.allFinite())
    return refuse(node, subject, fmt::format("'{}' has numbers that are not finite", node.text));
  WrittenValue written{{result}, measure.sure ? measure.dimension : std::nullopt, node.text};
  if (result.size() == 1) written.value.content = result(0, 0);
  return written;
}

bool ValueReader::is_bare_formula(const yaml::Node& node, bool only_number) const {
  const std::string& text = node.text;
  if (!node.is_scalar() || text.empty() || text[0] == '$' || text[0] == '=' ||
      text.find('$') != std::string::npos)
    return false;
  if ((node.quoted && !only_number) || unit::parse_quantity(text) || means_not_finite(text)) return false;
  if (!only_number && text.find_first_of("+-*/^(") == std::string::npos) return false;
  try {
    const bool has_variables = !parameters_.matrix_expression(text).variables().empty();
    return only_number || has_variables;
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
  const bool is_matrix = !node.items.empty() && node.items.front().is_list();
  for (yaml::Node& item : result.items) item = with_formulas(item, only_numbers || is_matrix);
  if (yaml::Entry* value = result.is_map() ? value_entry(result) : nullptr)
    value->value = with_formulas(value->value, only_numbers);
  return result;
}

std::optional<WrittenValue> ValueReader::read_list(const yaml::Node& node, const std::string& subject) const {
  if (!node.items.empty() && node.items.front().is_list()) return read_rows(node, subject);
  std::vector<WrittenValue> elements;
  for (const yaml::Node& item : node.items) {
    auto element = item.is_scalar() ? read_scalar(item, subject)
                                    : refuse(item, subject, "a list holds numbers or words");
    if (!element) return std::nullopt;
    elements.push_back(std::move(*element));
  }
  WrittenValue result{{Eigen::VectorXd(static_cast<Eigen::Index>(elements.size()))}, {}, "the list"};
  Value::List texts;
  bool numbers = true;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double* number = std::get_if<double>(&elements[i].value.content);
    numbers = numbers && number;
    if (number) std::get<Eigen::VectorXd>(result.value.content)[static_cast<Eigen::Index>(i)] = *number;
    if (elements[i].dimension && result.dimension && *elements[i].dimension != *result.dimension)
      return refuse(node.items[i], subject, "has another unit than the elements before it");
    if (elements[i].dimension) result.dimension = elements[i].dimension;
    texts.push_back({node.items[i].text, node.items[i].mark.line, node.items[i].mark.column});
  }
  if (!numbers) result.value.content = std::move(texts);
  return result;
}

std::optional<WrittenValue> ValueReader::read_rows(const yaml::Node& node, const std::string& subject) const {
  WrittenValue result{{Eigen::MatrixXd()}, {}, "the matrix"};
  auto& matrix = std::get<Eigen::MatrixXd>(result.value.content);
  bool one_unit = true;
  for (std::size_t row = 0; row < node.items.size(); ++row) {
    const yaml::Node& item = node.items[row];
    if (!item.is_list() || item.items.empty())
      return refuse(item, subject, "a matrix is a list of rows of numbers, as [[1, 2], [3, 4]]");
    const auto columns = static_cast<Eigen::Index>(item.items.size());
    if (row == 0) matrix.resize(static_cast<Eigen::Index>(node.items.size()), columns);
    if (columns != matrix.cols())
      return refuse(item, subject,
                    fmt::format("this row has {} numbers, the first has {}", columns, matrix.cols()));
    for (Eigen::Index column = 0; column < columns; ++column) {
      const yaml::Node& element = item.items[static_cast<std::size_t>(column)];
      const auto written = element.is_scalar() ? read_scalar(element, subject) : std::nullopt;
      const double* number = written ? std::get_if<double>(&written->value.content) : nullptr;
      if (element.is_scalar() && !written) return std::nullopt;
      if (!number) return refuse(item, subject, "a matrix is a list of rows of numbers, as [[1, 2], [3, 4]]");
      matrix(static_cast<Eigen::Index>(row), column) = *number;
      if (!written->dimension) continue;
      one_unit = one_unit && (!result.dimension || *result.dimension == *written->dimension);
      result.dimension = written->dimension;
    }
  }
  if (!one_unit) result.dimension.reset();  // the rows of a system have units of their own
  return result;
}

std::optional<WrittenValue> ValueReader::read_with_unit(const yaml::Node& node,
                                                        const std::string& subject) const {
  const yaml::Node* value = node.find("value");
  const yaml::Node* unit_node = node.find("unit");
  if (!value || node.entries.size() > (unit_node ? 2u : 1u))
    return refuse(node, subject, "is a map; a number with its unit is written {value: .., unit: ..}");
  auto written = read(*value, subject);
  if (!written || !unit_node) return written;
  const auto unit = unit::parse_unit(unit_node->text);
  if (!unit) return refuse(*unit_node, subject, fmt::format("'{}' is no unit", unit_node->text));
  if (written->dimension) return refuse(*unit_node, subject, "the numbers carry units already");
  if (auto* number = std::get_if<double>(&written->value.content)) *number = unit->to_si(*number);
  if (auto* vector = std::get_if<Eigen::VectorXd>(&written->value.content))
    for (double& element : *vector) element = unit->to_si(element);
  if (auto* matrix = std::get_if<Eigen::MatrixXd>(&written->value.content))
    for (double& element : matrix->reshaped()) element = unit->to_si(element);
  written->dimension = unit->dimension;
  written->text += " " + unit_node->text;
  return written;
}

std::optional<double> ValueReader::read_number(const yaml::Node& node, const unit::Dimension& demanded,
                                               const std::string& subject) const {
  const auto written = read(with_formulas(node, true), subject);
  if (!written) return std::nullopt;
  const double* number = std::get_if<double>(&written->value.content);
  if (!number && refuse_given(*written)) return std::nullopt;
  if (!number)
    return refuse(
        node, subject,
        fmt::format("'{}' is not a finite number with a unit", node.is_scalar() ? node.text : "a list"));
  const std::string complaint = unit_complaint(written->dimension, demanded);
  if (!complaint.empty()) return refuse(node, subject, fmt::format("'{}' {}", written->text, complaint));
  return *number;
}

std::optional<std::string> ValueReader::fill_in(const yaml::Node& node, const std::string& subject) const {
  std::string result;
  const std::string& text = node.text;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '$') {
      result += text[i++];
      continue;
    }
    if (text.substr(i, 2) == "$$") {
      result += '$';
      i += 2;
      continue;
    }
    const std::string name = word_at(text, i + 1);
    const WrittenValue* parameter = parameters_.find(name, uses_);
    if (parameter && parameter->failed) return std::nullopt;
    if (!parameter) return refuse(node, subject, no_parameter(name, parameters_));
    const auto inserted = inserted_text(parameter->value);
    if (!inserted)
      return refuse(node, subject, fmt::format("parameter '{}' is neither a number nor a word", name));
    result += *inserted;
    i += 1 + name.size();
  }
  return result;
}

}  // namespace stepwire::diagram
