// Values of block parameters: conversion to the declared kind, checks of range and unit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/base/expression/expression.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/diagram/quoted_number.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

constexpr std::string_view by = " by ";

/// Returns the quotient of the units of two consecutive coefficients.
unit::Dimension step_of(const ParameterSpec& spec) {
  const auto unit = unit::parse_unit(std::string_view(spec.unit).substr(spec.unit.find(by) + by.size()));
  return unit ? unit->dimension : unit::Dimension{};
}

bool are_scalars(const yaml::Node& list) {
  return list.is_list() &&
         std::ranges::all_of(list.items, [](const yaml::Node& item) { return item.is_scalar(); });
}

/// True for a list of coefficients, highest power first. Each has the unit of the next one times the unit
/// after "by": "'n by s".
bool are_coefficients(const ParameterSpec& spec) {
  return spec.unit.find(by) != std::string::npos;
}

/// Reads coefficients, each with an optional unit; the dimension is that of the last one. Adds a fault and
/// returns std::nullopt where a unit does not fit its power.
std::optional<WrittenValue> read_coefficients(const ValueReader& reader, FaultReport& report,
                                              const ParameterSpec& spec, const yaml::Node& list,
                                              const std::string& subject) {
  if (!are_scalars(list) || list.items.empty()) return reader.read(list, subject);
  const unit::Dimension step = step_of(spec);
  WrittenValue result{{Eigen::VectorXd(static_cast<Eigen::Index>(list.items.size()))}, {}, "the list"};
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const auto written = reader.read(list.items[i], subject);
    const double* number = written ? std::get_if<double>(&written->value.content) : nullptr;
    if (!number) return written ? reader.read(list, subject) : std::nullopt;
    std::get<Eigen::VectorXd>(result.value.content)[static_cast<Eigen::Index>(i)] = *number;
    if (!written->dimension) continue;
    const auto power = static_cast<double>(list.items.size() - 1 - i);
    const unit::Dimension last = *written->dimension / unit::power(step, power);
    if (!result.dimension) result.dimension = last;
    if (*result.dimension == last) continue;
    report.add(reader.at(list.items[i].mark), subject,
               fmt::format("{} is in {}; beside the coefficients before it, it must be in {}", written->text,
                           unit::si_name(*written->dimension),
                           unit::si_name(*result.dimension * unit::power(step, power))));
    return std::nullopt;
  }
  return result;
}

const char* wanted(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return "a finite number";
    case ParameterKind::integer:
      return "a whole number";
    case ParameterKind::flag:
      return "true or false";
    case ParameterKind::per_element:
      return "a finite number or a list of numbers";
    case ParameterKind::vector:
      return "a list of numbers";
    case ParameterKind::matrix:
      return "a list of rows of numbers, as [[1, 2], [3, 4]]";
    default:
      return "a word";
  }
}

std::optional<Eigen::VectorXd> as_vector(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content))
    return Eigen::VectorXd::Constant(1, *number);
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) return *vector;
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    return Eigen::VectorXd(matrix->reshaped());
  return std::nullopt;
}

std::optional<Value> as_matrix(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content))
    return Value{Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, *number))};
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    return Value{Eigen::MatrixXd(*vector)};
  if (std::holds_alternative<Eigen::MatrixXd>(value.content)) return value;
  return std::nullopt;
}

std::string broken_bound(const Range& range, double value) {
  if (range.above && !(value > *range.above)) return fmt::format("above {}", *range.above);
  if (range.at_least && !(value >= *range.at_least)) return fmt::format("at least {}", *range.at_least);
  if (range.below && !(value < *range.below)) return fmt::format("below {}", *range.below);
  if (range.at_most && !(value <= *range.at_most)) return fmt::format("at most {}", *range.at_most);
  return "";
}

/// Returns the invalid unit after a number, "Ns/m" of "8 Ns/m"; empty if the unit is valid or no number
/// begins the text.
std::string unknown_unit(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  std::string unit(end);
  unit.erase(0, unit.find_first_not_of(' '));
  return end == text.c_str() || unit.empty() || unit::parse_unit(unit) ? "" : unit;
}

/// True for a text that begins like a number and is none: 1_000, 0o17, 1:30, 1.5.2, 1,5. `unit` is its rest
/// from unknown_unit().
bool is_mistyped_number(const std::string& text, const std::string& unit) {
  constexpr std::string_view digits = "0123456789", after_number = "_:.,0123456789";
  if (unit.empty()) return false;
  const bool has_base = unit.size() > 1 && std::string_view("obOB").find(unit[0]) != std::string_view::npos &&
                        digits.find(unit[1]) != std::string_view::npos;
  return after_number.find(unit[0]) != std::string_view::npos || (has_base && text.starts_with('0'));
}

/// Returns the fault of a formula in the place of a number: an unknown parameter ("3*kk") or a missing '='.
/// Returns std::nullopt for other texts.
std::optional<yaml::Message> formula_fault(const std::string& text, const yaml::Node& node,
                                           const ParameterScope& parameters) {
  try {
    const expression::Expression formula(text);
    if (!node.is_scalar() || node.quoted || formula.variables().empty()) return std::nullopt;
    for (const std::string& name : formula.variables())
      if (const std::string cure = quantity_cure(text); !cure.empty() && !parameters.knows(name))
        return yaml::Message(fmt::format("there is no parameter '{}'", name) + cure);
      else if (!parameters.knows(name) && name != text)
        return fmt::format("there is no parameter '{}'", name) + yaml::did_you_mean(name, parameters.names());
    if (node.text.starts_with('$') && formula.variables().front() != text)
      return yaml::fault_text("'{0}' is a text there; a formula of parameters is written '= {0}'", text);
  } catch (const expression::ExpressionError&) {
  }
  return std::nullopt;
}

bool is_text(ParameterKind kind) {
  return kind == ParameterKind::word || kind == ParameterKind::text || kind == ParameterKind::file ||
         kind == ParameterKind::texts || kind == ParameterKind::tree;
}

yaml::Message other_word(const std::string& text, const std::vector<std::string>& words) {
  const std::string choice = fmt::format("It must be one of: {}", fmt::join(words, ", "));
  return fmt::format("'{}' is not allowed", text) + yaml::did_you_mean(text, words, choice);
}

/// Returns the fault of a value of the wrong kind.
yaml::Message no_value(const ParameterSpec& spec, const WrittenValue& written, const yaml::Node& node,
                       const ParameterScope& parameters) {
  if (auto fault = formula_fault(written.text, node, parameters)) return *fault;
  const std::string unit = unknown_unit(written.text);
  if (is_mistyped_number(written.text, unit))
    return yaml::fault_text("'{}' is no number; numbers are written 1000, 0.5 or 2e-3, with a unit 5 mm",
                            written.text);
  if (!unit.empty())
    return yaml::fault_text("'{}' is no unit; a product of units is written N s or N.s", unit);
  if (node.is_list() && node.items.empty())
    return fmt::format("the list is empty; it must be {}", wanted(spec.kind));
  const std::string what = node.is_scalar() && written.value.text() ? "'" + written.text + "'" : written.text;
  return yaml::fault_text("{} is not allowed; it must be {}", what, wanted(spec.kind));
}

/// Returns the index of the first element of a list that is no number; std::nullopt without one. `node` is
/// the list, or the name of a parameter.
std::optional<std::size_t> first_word(const WrittenValue& written, const yaml::Node& node) {
  const auto* list = std::get_if<Value::List>(&written.value.content);
  for (std::size_t k = 0; list && k < list->size(); ++k)
    if ((node.is_list() && node.items[k].quoted) || !unit::parse_quantity(*(*list)[k].text())) return k;
  return std::nullopt;
}

/// Returns the fault of an element of a list that is no number.
yaml::Message no_number(const WrittenValue& list, std::size_t element, const yaml::Node& node,
                        const ParameterScope& parameters) {
  yaml::Node word;
  word.kind = yaml::Node::Kind::scalar;
  word.text = *std::get<Value::List>(list.value.content)[element].text();
  word.quoted = node.is_list() && node.items[element].quoted;
  ParameterSpec number;
  number.kind = ParameterKind::number;
  yaml::Message message = word.quoted && unit::parse_quantity(word.text)
                              ? quoted_number(word.text)
                              : no_value(number, {{word.text}, {}, word.text}, word, parameters);
  message.wrong = fmt::format("element {} of the list: ", element + 1) + message.wrong;
  return message;
}

}  // namespace

std::optional<unit::Dimension> demanded_dimension(const ParameterSpec& spec) {
  if (spec.unit.find('\'') != std::string::npos || spec.unit == "*") return std::nullopt;
  const auto unit = unit::parse_unit(spec.unit);
  return unit ? std::optional(unit->dimension) : std::nullopt;
}

const ParameterSpec& numbers_of_any_unit() {
  static const ParameterSpec spec = [] {
    ParameterSpec numbers;
    numbers.kind = ParameterKind::per_element;
    numbers.unit = "*";
    return numbers;
  }();
  return spec;
}

std::optional<WrittenValue> ValueReader::read_for(const ParameterSpec& spec,
                                                  const std::optional<unit::Dimension>& demanded,
                                                  const yaml::Node& node, const std::string& subject) const {
  if (is_text(spec.kind)) return read_words(spec, node, subject);
  const yaml::Node value_node = with_formulas(node, spec.kind != ParameterKind::flag);
  auto written = are_coefficients(spec) ? read_coefficients(*this, report_, spec, value_node, subject)
                                        : read(value_node, subject);
  if (!written) return std::nullopt;
  if (has_wrong_unit(spec, *written, demanded, node, subject)) return std::nullopt;
  auto value = convert(spec, *written, node, subject);
  if (!value) return std::nullopt;
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&written->value.content);
      matrix && spec.kind == ParameterKind::per_element)
    written->columns = matrix->cols();
  written->value = std::move(*value);
  if (!in_range(spec, *written, node, subject)) return std::nullopt;
  return written;
}

bool ValueReader::has_wrong_unit(const ParameterSpec& spec, const WrittenValue& written,
                                 const std::optional<unit::Dimension>& demanded, const yaml::Node& node,
                                 const std::string& subject) const {
  // Lists of their own length, such as the points of a table, are in one unit.
  const bool is_alike = spec.kind == ParameterKind::vector && spec.unit.find('\'') != std::string::npos;
  const auto first = std::ranges::find_if(written.each, [](const auto& unit) { return unit.has_value(); });
  const auto wanted = is_alike && first != written.each.end() ? *first : demanded;
  const std::string fault = unit_fault(written, wanted);
  if (fault.empty()) return false;
  const auto wrong = wrong_element(written.each, wanted);
  const bool has_items = wrong && node.items.size() == written.each.size();
  refuse(has_items ? node.items[*wrong] : node, subject, fault);
  return true;
}

std::optional<Value> ValueReader::convert(const ParameterSpec& spec, const WrittenValue& written,
                                          const yaml::Node& node, const std::string& subject) const {
  const Value& value = written.value;
  const double* number = std::get_if<double>(&value.content);
  if (spec.kind == ParameterKind::number && number) return value;
  if (spec.kind == ParameterKind::integer && number && std::floor(*number) == *number &&
      std::abs(*number) < 9e15)
    return value;
  if (spec.kind == ParameterKind::flag && std::holds_alternative<bool>(value.content)) return value;
  const auto* matrix_value = std::get_if<Eigen::MatrixXd>(&value.content);
  const bool is_matrix = matrix_value && matrix_value->rows() > 1 && matrix_value->cols() > 1;
  if (spec.kind == ParameterKind::per_element || (spec.kind == ParameterKind::vector && !is_matrix))
    if (auto vector = as_vector(value); vector && vector->size() > 0) return Value{std::move(*vector)};
  if (spec.kind == ParameterKind::matrix)
    if (auto matrix = as_matrix(value)) return matrix;
  if (spec.kind != ParameterKind::flag && refuse_given(written)) return std::nullopt;
  if (const auto word = first_word(written, node)) {
    yaml::Message message = no_number(written, *word, node, parameters_);
    if (!written.given) return refuse(node.is_list() ? node.items[*word] : node, subject, std::move(message));
    report_.add(written.given->origin, written.given->name, std::move(message));
    return std::nullopt;
  }
  if (node.quoted && unit::parse_quantity(node.text)) return refuse(node, subject, quoted_number(node.text));
  return refuse(node, subject, no_value(spec, written, node, parameters_));
}

bool ValueReader::in_range(const ParameterSpec& spec, const WrittenValue& written, const yaml::Node& node,
                           const std::string& subject) const {
  std::string broken;
  const auto check = [&](double element) {
    if (broken.empty()) broken = broken_bound(spec.range, element);
  };
  if (const double* number = std::get_if<double>(&written.value.content)) check(*number);
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&written.value.content))
    for (double element : *vector) check(element);
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&written.value.content))
    for (double element : matrix->reshaped()) check(element);
  if (broken.empty()) return true;
  const bool with_unit =
      !spec.unit.empty() && spec.unit != "1" && spec.unit != "*" && spec.unit.find('\'') == std::string::npos;
  const std::string unit = with_unit && !broken.ends_with(" 0") ? " " + spec.unit : "";
  refuse(node, subject, yaml::fault_text("{} is not allowed; it must be {}{}", written.text, broken, unit));
  return false;
}

std::optional<WrittenValue> ValueReader::read_words(const ParameterSpec& spec, const yaml::Node& node,
                                                    const std::string& subject) const {
  if (spec.kind == ParameterKind::tree) {
    auto tree = read_tree(node, subject, !spec.formulas.empty());
    return tree ? std::optional(WrittenValue{std::move(*tree), {}, "the tree"}) : std::nullopt;
  }
  if (spec.kind == ParameterKind::texts) {
    Value::List list;
    for (const yaml::Node& item : node.as_list()) {
      const auto text = item.is_scalar() ? fill_in(item, subject) : refuse(item, subject, "must be a word");
      if (!text) return std::nullopt;
      list.push_back({*text, item.mark.line, item.mark.column});
    }
    return WrittenValue{{std::move(list)}, {}, "the list"};
  }
  if (!node.is_scalar()) return refuse(node, subject, "must be a word");
  const auto text = fill_in(node, subject, !spec.formulas.empty());
  if (!text) return std::nullopt;
  if (spec.kind == ParameterKind::file) {
    const std::string path = resolve_file(*text, node, subject);
    return path.empty() ? std::nullopt : std::optional(WrittenValue{{path}, {}, *text});
  }
  if (spec.kind == ParameterKind::text)
    return WrittenValue{{*text, node.mark.line, node.mark.column}, {}, *text};
  for (std::size_t i = 0; i < spec.words.size(); ++i)
    if (spec.words[i] == *text) return WrittenValue{{static_cast<double>(i)}, {}, *text};
  return refuse(node, subject, other_word(*text, spec.words));
}

std::optional<Value> ValueReader::read_tree(const yaml::Node& node, const std::string& subject,
                                            bool has_formulas) const {
  Value result;
  result.line = node.mark.line;
  result.column = node.mark.column;
  if (node.is_scalar()) {
    const auto text = fill_in(node, subject, has_formulas);
    if (!text) return std::nullopt;
    result.content = *text;
  } else if (node.is_list()) {
    Value::List list;
    for (const yaml::Node& item : node.items) {
      auto value = read_tree(item, subject, has_formulas);
      if (!value) return std::nullopt;
      list.push_back(std::move(*value));
    }
    result.content = std::move(list);
  } else {
    Value::Map map;
    for (const yaml::Entry& entry : node.entries) {
      auto value = read_tree(entry.value, subject, has_formulas);
      if (!value) return std::nullopt;
      map.push_back({entry.key, std::move(*value)});
    }
    result.content = std::move(map);
  }
  return result;
}

std::string ValueReader::resolve_file(const std::string& text, const yaml::Node& node,
                                      const std::string& subject) const {
  namespace fs = std::filesystem;
  const fs::path path(text);
  if (path.is_absolute()) return path.string();
  if (path.begin() != path.end() && *path.begin() == "data") {
    const char* named = std::getenv("STEPWIRE_DATA");
    const std::string folder = named ? named : "";
    std::error_code none;
    if (fs::is_directory(folder, none)) return (fs::path(folder) / path.lexically_relative("data")).string();
    const std::string why = folder.empty() ? "set STEPWIRE_DATA to that folder"
                                           : fmt::format("STEPWIRE_DATA is '{}', which is no folder", folder);
    throw io::EnvironmentError(
        report_.fault(at(node.mark), subject, yaml::fault_text("'{}' is in the data folder; {}", text, why))
            .text());
  }
  return (fs::path(report_.file_of(scope_)).parent_path() / path).string();
}

}  // namespace stepwire::diagram
