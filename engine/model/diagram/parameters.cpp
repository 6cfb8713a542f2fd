#include "engine/model/diagram/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/base/unit/meaning.hpp"
#include "engine/base/yaml/message.hpp"
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

/// Common unit of the elements of a matrix; std::nullopt if elements differ, as rows of a state-space system
/// may.
class MatrixUnit {
 public:
  void add(const std::optional<unit::Dimension>& dimension) {
    if (!dimension) return;
    differs_ = differs_ || (unit_ && *unit_ != *dimension);
    unit_ = dimension;
  }
  std::optional<unit::Dimension> common() const { return differs_ ? std::nullopt : unit_; }

 private:
  std::optional<unit::Dimension> unit_;
  bool differs_ = false;
};

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

}  // namespace

std::string unit_complaint(const std::optional<unit::Dimension>& written,
                           const std::optional<unit::Dimension>& demanded) {
  if (!written || !demanded) return "";
  if (*written == *demanded) return unit::other_meaning_of_number(*written, *demanded);
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
  if (!written.given) return false;
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
  const char* const no_matrix = "a matrix is a list of rows of numbers, as [[1, 2], [3, 4]]";
  const auto columns = static_cast<Eigen::Index>(node.items.front().items.size());
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(node.items.size()), columns);
  MatrixUnit unit;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    const yaml::Node& item = node.items[static_cast<std::size_t>(row)];
    if (!item.is_list() || item.items.empty()) return refuse(item, subject, no_matrix);
    if (static_cast<Eigen::Index>(item.items.size()) != columns)
      return refuse(item, subject,
                    fmt::format("this row has {} numbers, the first has {}", item.items.size(), columns));
    for (Eigen::Index column = 0; column < columns; ++column) {
      const yaml::Node& element = item.items[static_cast<std::size_t>(column)];
      const auto written = element.is_scalar() ? read_scalar(element, subject) : std::nullopt;
      if (element.is_scalar() && !written) return std::nullopt;
      const double* number = written ? std::get_if<double>(&written->value.content) : nullptr;
      if (!number) return refuse(item, subject, no_matrix);
      matrix(row, column) = *number;
      unit.add(written->dimension);
    }
  }
  return WrittenValue{{std::move(matrix)}, unit.common(), "the matrix"};
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

}  // namespace stepwire::diagram
