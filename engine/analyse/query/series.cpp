#include "engine/analyse/query/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::query {
namespace {

/// Returns the message for a value that cannot be drawn in a unit of its dimension; empty if it can.
std::string drawn_fault(const unit::Dimension& given, const unit::Dimension& wanted) {
  const std::string other = unit::other_meaning(given, wanted);
  const bool scales =
      given.zeros && !unit::are_zeros(*given.zeros, 0.0) && !unit::are_zeros(*given.zeros, 1.0);
  if (other.empty() || (scales && unit::is_temperature(wanted))) return other;
  return other + "; " + (unit::is_temperature(wanted) ? "draw it in K" : unit::cure_of_rate(given, wanted));
}

/// Returns the dimension of a formula without a known unit whose columns are made of temperatures;
/// std::nullopt for others.
std::optional<unit::Dimension> dimension_if_kelvin(const Formula& formula, const SymbolTable& names) {
  std::vector<expression::Measure> measures;
  for (const std::string& name : formula.expression.variables()) {
    const RecordedName& column = *names.find(name);
    measures.push_back({column.dimension, column.dimension.has_value()});
    if (column.dimension || !column.zeros_if_kelvin) continue;
    unit::Dimension kelvin{{0, 0, 0, 0, 1}};
    kelvin.zeros = column.zeros_if_kelvin;
    measures.back() = {kelvin, true};
  }
  try {
    return formula.expression.measure(measures).dimension;
  } catch (const expression::ExpressionError&) {
    return std::nullopt;  // its columns are in other units
  }
}

/// Reads the unit after " in " and checks that the formula can be drawn in it.
bool read_unit(const yaml::Node& node, std::string_view text, std::size_t offset, Series& series,
               const SymbolTable& names, const std::string& subject, yaml::Faults& faults) {
  const auto unit = unit::parse_unit(text);
  const auto& known = series.formula.dimension;
  const auto dimension = known ? known : dimension_if_kelvin(series.formula, names);
  std::string message;
  if (!unit)
    message = fmt::format("'{}' is no unit", text);
  else if (known && *known != unit->dimension)
    message = fmt::format("'{}' is in {} and cannot be drawn in {}", series.formula.text,
                          unit::si_name(*known), text);
  else if (series.formula.is_ratio && unit->dimension.angle != 0.0)
    message = fmt::format("'{}' is a pure number and cannot be drawn in {}", series.formula.text, text);
  else if (const std::string other = dimension ? drawn_fault(*dimension, unit->dimension) : "";
           !other.empty())
    message = fmt::format("'{}' {}", series.formula.text, other);
  if (!message.empty()) {
    faults.add({place_in(node, offset, names), subject, message, {}});
    return false;
  }
  series.unit = *unit;
  series.unit_text = std::string(text);
  return true;
}

/// Returns "force of left damper" for the bare name left_damper.force; other formulas unchanged.
std::string words_of(const Formula& formula) {
  const std::string& text = formula.text;
  const bool bare = formula.columns.size() == 1 && formula.columns.front() == text;
  if (!bare) return text;
  // A trailing number is an index and stays with the name before it.
  std::size_t last = text.find_last_of('.');
  while (last != std::string::npos && last > 0 && std::isdigit(static_cast<unsigned char>(text[last + 1])))
    last = text.find_last_of('.', last - 1);
  std::string words =
      last == std::string::npos ? text : text.substr(last + 1) + " of " + text.substr(0, last);
  std::ranges::replace_if(
      words, [](char c) { return c == '.' || c == '_'; }, ' ');
  return words;
}

std::optional<Series> read_signal(const yaml::Node& node, const SymbolTable& names,
                                  const std::string& subject, yaml::Faults& faults) {
  const std::size_t in = node.is_scalar() ? node.text.rfind(" in ") : std::string::npos;
  auto formula = in == std::string::npos ? read_formula(node, names, subject, faults)
                                         : read_formula(node, std::string_view(node.text).substr(0, in), 0,
                                                        names, subject, faults);
  if (!formula) return std::nullopt;
  const RecordedName* replaced = names.find(formula->text);
  if (replaced && !replaced->expression.empty()) formula->text = replaced->expression;
  Series series{*formula, unit::Unit{}, "", words_of(*formula)};
  if (in == std::string::npos) {
    if (formula->dimension) series.unit_text = unit::si_name(*formula->dimension);
    return series;
  }
  const std::size_t start = node.text.find_first_not_of(' ', in + 4);
  const std::size_t end = node.text.find_last_not_of(' ') + 1;
  const std::string_view unit =
      std::string_view(node.text).substr(std::min(start, end), end - std::min(start, end));
  if (!read_unit(node, unit, start, series, names, subject, faults)) return std::nullopt;
  return series;
}

}  // namespace

std::string printed_unit(const std::string& unit) {
  if (unit.empty() || unit == "1") return "–";
  std::string text = unit;
  text::replace_all(text, "^2", "²");
  text::replace_all(text, "^3", "³");
  text::replace_all(text, ".", "·");
  if (text == "deg") return "°";
  if (text == "um") return "µm";
  return text;
}

std::string unit_cure(const Formula& formula, const unit::Dimension& wanted) {
  const bool bare = formula.columns.size() == 1 && formula.columns.front() == formula.text;
  const bool is_signal = bare && formula.recording;
  const std::string unit = unit::si_name(wanted);
  const std::string head =
      is_signal ? fmt::format(", or in the head units: {{{}: {}}}", formula.text, unit) : "";
  return fmt::format("name its SI unit behind it, as '{} in {}'{}", formula.text, unit, head);
}

std::string Series::axis_label() const {
  return unit_text.empty() ? label : fmt::format("{} [{}]", label, printed_unit(unit_text));
}

std::optional<Series> read_series(const yaml::Node& node, const SymbolTable& names,
                                  const std::string& subject, yaml::Faults& faults) {
  if (!node.is_map()) return read_signal(node, names, subject, faults);
  NamesReading(subject, names, faults).check(node, series_form());
  const yaml::Node* signal = node.find("signal");
  if (signal == nullptr) return std::nullopt;
  auto series = read_signal(*signal, names, subject, faults);
  const yaml::Node* label = node.find("label");
  if (series && label != nullptr) series->label = read_text(*label, names, subject, faults);
  return series;
}

}  // namespace stepwire::query
