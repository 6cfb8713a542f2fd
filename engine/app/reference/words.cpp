#include "engine/app/reference/words.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "engine/base/unit/unit.hpp"

namespace stepwire::reference {

namespace {

bool is_upper(char c) {
  return std::isupper(static_cast<unsigned char>(c));
}
bool is_lower(char c) {
  return std::islower(static_cast<unsigned char>(c));
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c));
}

/// True if a new word begins at this letter: "MR|Damper", "Lookup|Table|2D", but "Atan2".
bool begins_word(const std::string& name, std::size_t i) {
  if (i == 0) return false;
  const char before = name[i - 1], after = i + 1 < name.size() ? name[i + 1] : ' ';
  if (is_digit(name[i])) return is_lower(before) && is_upper(after);
  return is_upper(name[i]) && (is_lower(before) || (is_upper(before) && is_lower(after)));
}

/// Returns a number in the unit of its parameter, without writing the unit.
std::string bare_text(const ParameterSpec& spec, double value) {
  if (!std::isfinite(value)) return "none";
  const auto unit = unit::parse_unit(fixed_unit(spec.unit));
  return fmt::format("{}", unit ? unit->from_si(value) : value);
}

std::string with_unit(const ParameterSpec& spec, const std::string& text) {
  const std::string unit = fixed_unit(spec.unit);
  return unit.empty() || text == "none" ? text : text + " " + unit;
}

std::string number_text(const ParameterSpec& spec, double value) {
  return with_unit(spec, bare_text(spec, value));
}

template <class Numbers>
std::string list_text(const ParameterSpec& spec, const Numbers& numbers) {
  std::string text;
  for (Eigen::Index i = 0; i < numbers.size(); ++i) text += (i ? ", " : "") + bare_text(spec, numbers[i]);
  return "[" + text + "]";
}

std::string matrix_text(const ParameterSpec& spec, const Eigen::MatrixXd& matrix) {
  std::string text;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    text += (row ? ", " : "") + list_text(spec, Eigen::VectorXd(matrix.row(row)));
  return "[" + text + "]";
}

/// Quotes a text unless it is a plain word in YAML.
std::string quoted(const std::string& text) {
  bool bare = !text.empty() && std::isalpha(static_cast<unsigned char>(text[0]));
  for (char c : text) bare = bare && (std::isalnum(static_cast<unsigned char>(c)) || c == '_');
  return bare ? text : "\"" + text + "\"";
}

std::string texts_text(const Value::List& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i)
    text += (i ? ", " : "") + (list[i].text() ? quoted(*list[i].text()) : "...");
  return "[" + text + "]";
}

}  // namespace

std::string snake_case(const std::string& name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (begins_word(name, i)) result += '_';
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return result;
}

std::string first_sentence(const std::string& text) {
  // A sentence ends before a capital, so "e.g. this" does not end one.
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
    if (text[i] == '.' && text[i + 1] == ' ' && is_upper(text[i + 2])) return text.substr(0, i + 1);
  return text;
}

std::string kind_text(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return "number";
    case ParameterKind::integer:
      return "whole number";
    case ParameterKind::flag:
      return "true or false";
    case ParameterKind::word:
      return "word";
    case ParameterKind::text:
      return "text";
    case ParameterKind::file:
      return "file";
    case ParameterKind::per_element:
      return "number or list";
    case ParameterKind::vector:
      return "list of numbers";
    case ParameterKind::matrix:
      return "matrix";
    case ParameterKind::texts:
      return "list of words";
    case ParameterKind::tree:
      return "map or list";
  }
  return "";
}

std::string fixed_unit(const std::string& declared) {
  const bool open = declared == "1" || declared == "*" || declared.find('\'') != std::string::npos;
  return open ? "" : declared;
}

std::string value_text(const ParameterSpec& spec, const Value& value) {
  if (const double* number = std::get_if<double>(&value.content)) {
    if (spec.kind != ParameterKind::word) return number_text(spec, *number);
    const auto index = static_cast<std::size_t>(*number);
    return index < spec.words.size() ? spec.words[index] : "";
  }
  if (const bool* flag = std::get_if<bool>(&value.content)) return *flag ? "true" : "false";
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) {
    const bool one = spec.kind == ParameterKind::per_element && vector->size() == 1;
    return one ? number_text(spec, (*vector)[0]) : with_unit(spec, list_text(spec, *vector));
  }
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    return with_unit(spec, matrix_text(spec, *matrix));
  if (value.list()) return texts_text(*value.list());
  return value.text() ? quoted(*value.text()) : "none";
}

Value default_of(const BlockType& type, const ParameterSpec& spec) {
  const AnyBlock block(type);
  return spec.get(block.get());
}

std::string default_text(const BlockType& type, const ParameterSpec& spec) {
  return spec.required ? "required" : value_text(spec, default_of(type, spec));
}

std::string allowed_text(const ParameterSpec& spec) {
  if (!spec.words.empty()) return fmt::format("{}", fmt::join(spec.words, ", "));
  std::vector<std::string> bounds;
  const auto add = [&](const char* words, const std::optional<double>& bound) {
    if (!bound) return;
    bounds.push_back(fmt::format("{} {}", words, *bound == 0.0 ? "0" : number_text(spec, *bound)));
  };
  add("above", spec.range.above);
  add("at least", spec.range.at_least);
  add("below", spec.range.below);
  add("at most", spec.range.at_most);
  return fmt::format("{}", fmt::join(bounds, ", "));
}

std::string timing_text(Timing timing) {
  switch (timing) {
    case Timing::inherited:
      return "at the rate of its inputs; once at the start if it has none";
    case Timing::continuous:
      return "continuous: follows time and the solver";
    case Timing::discrete:
      return "discrete: at ticks, every `every`; without it at the period of its inputs, or at every step";
  }
  return "";
}

std::string feedthrough_text(const BlockType& type) {
  if (type.inputs.empty() || type.outputs.empty()) return "";
  std::vector<std::string> names;
  for (const InputSpec& input : type.inputs)
    if (input.feedthrough) names.push_back(input.name);
  if (names.empty()) return "none: the outputs depend on earlier values only, so the block may close a loop";
  return fmt::format("the outputs depend at the same instant on {}", fmt::join(names, ", "));
}

}  // namespace stepwire::reference
