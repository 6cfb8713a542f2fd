#include "engine/model/diagram/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "engine/base/text/count.hpp"
#include "engine/base/unit/meaning.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/bare_number.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/formula_units.hpp"
#include "engine/model/diagram/quoted_number.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

yaml::Message no_parameter(const std::string& name, const ParameterScope& parameters) {
  return fmt::format("there is no parameter '{}'", name) + yaml::did_you_mean(name, parameters.names());
}

/// Returns the letters, digits and underscores from `begin` on.
std::string word_at(const std::string& text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
    ++end;
  return text.substr(begin, end - begin);
}

/// Units of the elements of a list or matrix, counted in column-major order.
class UnitsOfElements {
 public:
  explicit UnitsOfElements(Eigen::Index size) : each_(static_cast<std::size_t>(size)) {}

  /// Takes the unit of a number, and its place.
  void set(Eigen::Index element, const WrittenValue& written, const yaml::Node& node,
           const ParameterScope& parameters) {
    const std::optional<unit::Dimension>& dimension = written.dimension;
    each_[static_cast<std::size_t>(element)] = dimension;
    const double* number = std::get_if<double>(&written.value.content);
    if (number && !dimension && *number != 0.0 && !bare_ && has_no_unit(written.text, parameters))
      bare_ = {&node, element};
    if (!dimension) return;
    if (scaled_.empty() && is_scaled(written_unit(written.text))) scaled_ = written.text;
    differs_ = differs_ || (common_ && *common_ != *dimension);
    if (!common_ || !common_->zeros) common_ = dimension;
    has_degrees_ = has_degrees_ || dimension->zeros || dimension->per_difference;
  }
  /// True for units of temperatures beside others: what they mean is checked for whole signals alone.
  bool mixes_temperatures() const { return differs_ && has_degrees_; }
  /// Returns the fault of a number or formula without unit beside a number in a unit other than SI, and its
  /// place.
  std::optional<std::pair<const yaml::Node*, yaml::Message>> bare_fault() const {
    if (!bare_ || scaled_.empty() || differs_) return std::nullopt;
    return std::pair{bare_->first,
                     yaml::fault_text("element {} is {}, which has no unit beside {}; give it one",
                                      bare_->second + 1, bare_->first->text, scaled_)};
  }
  /// Returns numbers with these units.
  WrittenValue written(Value value, std::string text) && {
    WrittenValue result{std::move(value), differs_ ? std::nullopt : common_, std::move(text)};
    if (differs_) result.each = std::move(each_);
    return result;
  }

 private:
  static std::string written_unit(const std::string& text) {
    yaml::Node node;
    node.kind = yaml::Node::Kind::scalar;
    node.text = text;
    return unit_as_written(node);
  }

  /// True for a number without unit, and for a formula in which nothing has a unit.
  static bool has_no_unit(const std::string& text, const ParameterScope& parameters) {
    if (!text.starts_with('=')) return written_unit(text).empty();
    const expression::Expression* const formula = parameters.expression(text.substr(1));
    if (!formula) return false;
    ParameterUses none;
    std::vector<expression::Measure> measures;
    for (const std::string& name : formula->variables()) {
      const WrittenValue* const parameter = parameters.find(name, &none);
      if (!parameter || parameter->dimension || !parameter->each.empty()) return false;
      measures.push_back({std::nullopt, false});
    }
    const auto dimension = formula->measure(measures).dimension;
    return !dimension || *dimension == unit::Dimension{};
  }

  EachUnit each_;
  std::optional<unit::Dimension> common_;
  std::optional<std::pair<const yaml::Node*, Eigen::Index>> bare_;  ///< first number without unit
  std::string scaled_;                                              ///< first number in a unit other than SI
  bool differs_ = false, has_degrees_ = false;
};

const char* const no_mixed_temperatures =
    "has a temperature in degC beside elements in other units; write it in K";

/// Returns a number or word for insertion into a text, in a formula with its unit; std::nullopt for any other
/// value.
std::optional<std::string> inserted_text(const WrittenValue& written, bool is_formula) {
  const Value& value = written.value;
  if (const double* number = std::get_if<double>(&value.content); number && is_formula && written.dimension)
    return quantity_in_formula(*number, *written.dimension);
  if (const double* number = std::get_if<double>(&value.content))
    return *number < 0 ? fmt::format("({})", *number) : fmt::format("{}", *number);
  return value.text() ? std::optional(*value.text()) : std::nullopt;
}

/// True for a formula of parameters, as $name, and of signals: "$width*cos(y)". It is a text, whose signals
/// have a meaning where it is used.
bool names_signals(std::string text, const ParameterScope& parameters) {
  if (text.find('$') == std::string::npos) return false;
  std::erase(text, '$');
  try {
    const expression::Expression formula(text);
    const auto knows = [&](const std::string& name) { return parameters.knows(name); };
    return std::ranges::any_of(formula.variables(), knows) &&
           !std::ranges::all_of(formula.variables(), knows);
  } catch (const expression::ExpressionError&) {
    return false;
  }
}

// Formulas of parameters: of single numbers, and of matrices.

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
/// so that the reader of the value refuses it. So does a multiple of W/degC, since it takes no temperature.
std::optional<unit::Dimension> dimension_of(const expression::Measure& measure) {
  const auto& dimension = measure.dimension;
  const bool is_known =
      measure.sure ||
      (dimension && (dimension->per_difference || !unit::other_meaning(*dimension, *dimension).empty()));
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

std::string quantity_cure(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  const std::string number(text.c_str(), static_cast<const char*>(end)), rest(end);
  if (number.empty() || (!rest.starts_with('/') && !rest.starts_with('*'))) return "";
  const std::string meant = number + (rest[0] == '/' ? " 1" + rest : " " + rest.substr(1));
  return unit::parse_quantity(meant) ? fmt::format("; a number with its unit is written '{}'", meant) : "";
}

std::string unit_complaint(const std::optional<unit::Dimension>& written,
                           const std::optional<unit::Dimension>& demanded) {
  if (!written || !demanded) return "";
  if (*written == *demanded) return unit::other_meaning_of_number(*written, *demanded);
  if (*demanded == unit::Dimension{} && demanded->angle == 0.0)
    return fmt::format("is in {}; it must be a pure number, without a unit", unit::si_name(*written));
  return fmt::format("is in {}; it must be in {}", unit::si_name(*written), unit::si_name(*demanded));
}

std::optional<std::size_t> wrong_element(const EachUnit& written,
                                         const std::optional<unit::Dimension>& demanded) {
  for (std::size_t k = 0; k < written.size(); ++k)
    if (!unit_complaint(written[k], demanded).empty()) return k;
  return std::nullopt;
}

std::string unit_fault(const WrittenValue& written, const std::optional<unit::Dimension>& demanded) {
  if (const auto k = wrong_element(written.each, demanded))
    return fmt::format("element {} of {} {}", *k + 1, written.text,
                       unit_complaint(written.each[*k], demanded));
  const std::string complaint = unit_complaint(written.dimension, demanded);
  return complaint.empty() ? "" : fmt::format("{} {}", written.text, complaint);
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
  // Quotes do not prevent an expression: one with a comma, a colon or a quotation mark needs them.
  if (node.quoted && !text.starts_with('='))
    return names_signals(text, parameters_) ? read_text(node, subject) : WrittenValue{{text}, {}, text};
  if (text.starts_with('$')) {
    if (parameters_.failed(text.substr(1))) return std::nullopt;
    if (const WrittenValue* parameter = parameters_.find(text.substr(1), uses_)) return *parameter;
    if (names_signals(text, parameters_)) return read_text(node, subject);
    return refuse(node, subject, no_parameter(text.substr(1), parameters_));
  }
  if (text.starts_with('=')) return read_expression(node, subject);
  if (const auto quantity = unit::parse_quantity(text))
    return WrittenValue{{quantity->value}, quantity->dimension, text};
  if (means_not_finite(text))
    return refuse(node, subject,
                  yaml::fault_text("'{}' is not a finite number; give one, or leave the key out", text));
  if (text == "true" || text == "false") return WrittenValue{{text == "true"}, {}, text};
  return read_text(node, subject);
}

/// Reads a text with names of parameters in it, such as data/$name.csv.
std::optional<WrittenValue> ValueReader::read_text(const yaml::Node& node, const std::string& subject) const {
  const auto filled = fill_in(node, subject);
  return filled ? std::optional(WrittenValue{{*filled}, {}, *filled}) : std::nullopt;
}

/// Returns the numbers of a list; its texts where one of them is a word.
static Value list_of(const std::vector<WrittenValue>& elements, const std::vector<yaml::Node>& items) {
  Value list{Eigen::VectorXd(static_cast<Eigen::Index>(elements.size()))};
  Value::List texts;
  bool numbers = true;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double* number = std::get_if<double>(&elements[i].value.content);
    numbers = numbers && number;
    if (number) std::get<Eigen::VectorXd>(list.content)[static_cast<Eigen::Index>(i)] = *number;
    texts.push_back({items[i].text, items[i].mark.line, items[i].mark.column});
  }
  if (!numbers) list.content = std::move(texts);
  return list;
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
  Value list = list_of(elements, node.items);
  UnitsOfElements units(static_cast<Eigen::Index>(elements.size()));
  for (std::size_t i = 0; i < elements.size(); ++i)
    units.set(static_cast<Eigen::Index>(i), elements[i], node.items[i], parameters_);
  if (auto fault = units.bare_fault()) return refuse(*fault->first, subject, std::move(fault->second));
  if (units.mixes_temperatures()) return refuse(node, subject, no_mixed_temperatures);
  return std::move(units).written(std::move(list), "the list");
}

std::optional<WrittenValue> ValueReader::read_rows(const yaml::Node& node, const std::string& subject) const {
  const char* const no_matrix = "a matrix is a list of rows of numbers, as [[1, 2], [3, 4]]";
  const auto columns = static_cast<Eigen::Index>(node.items.front().items.size());
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(node.items.size()), columns);
  UnitsOfElements units(matrix.size());
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    const yaml::Node& item = node.items[static_cast<std::size_t>(row)];
    if (!item.is_list() || item.items.empty()) return refuse(item, subject, no_matrix);
    if (static_cast<Eigen::Index>(item.items.size()) != columns)
      return refuse(item, subject,
                    fmt::format("this row has {}, the first has {}",
                                text::counted(item.items.size(), "number"), columns));
    for (Eigen::Index column = 0; column < columns; ++column) {
      const yaml::Node& element = item.items[static_cast<std::size_t>(column)];
      const auto written = element.is_scalar() ? read_scalar(element, subject) : std::nullopt;
      if (element.is_scalar() && !written) return std::nullopt;
      const double* number = written ? std::get_if<double>(&written->value.content) : nullptr;
      if (!number) return refuse(item, subject, no_matrix);
      matrix(row, column) = *number;
      units.set(column * matrix.rows() + row, *written, element, parameters_);
    }
  }
  if (auto fault = units.bare_fault()) return refuse(*fault->first, subject, std::move(fault->second));
  if (units.mixes_temperatures()) return refuse(node, subject, no_mixed_temperatures);
  return std::move(units).written({std::move(matrix)}, "the matrix");
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
  if (written->dimension || !written->each.empty())
    return refuse(*unit_node, subject,
                  "the numbers have units already; leave the key 'unit' out, or write the numbers alone");
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

std::optional<std::string> ValueReader::fill_in(const yaml::Node& node, const std::string& subject,
                                                bool is_formula) const {
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
    const auto inserted = inserted_text(*parameter, is_formula);
    if (!inserted)
      return refuse(node, subject, fmt::format("parameter '{}' is neither a number nor a word", name));
    result += *inserted;
    i += 1 + name.size();
  }
  return result;
}

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
    matrix_expression(text);  // throws for an invalid matrix expression as well
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
    report_.add(at(mark), subject, error.what() + quantity_cure(node.text.substr(1)));
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
  if (!parameter.each.empty())
    parameter.dimension = parameter.each[static_cast<std::size_t>((column - 1) * matrix->rows() + row - 1)];
  parameter.each.clear();
  parameter.value.content = (*matrix)(row - 1, column - 1);
  return parameter;
}

std::optional<WrittenValue> ValueReader::read_matrices(const std::vector<WrittenValue>& values,
                                                       const yaml::Node& node,
                                                       const std::string& subject) const {
  const expression::MatrixExpression& expression = parameters_.matrix_expression(node.text.substr(1));
  const bool is_several =
      std::ranges::any_of(values, [](const WrittenValue& value) { return !value.each.empty(); });
  const std::size_t begin = node.text.find_first_not_of(" =");
  if (is_several && node.text.substr(begin) == expression.variables().front()) return values.front();
  if (is_several)
    return refuse(node, subject,
                  fmt::format("'{}' calculates with a list whose elements have several units; write each "
                              "element, as [= 2*k.1, = 2*k.2]",
                              node.text));
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
