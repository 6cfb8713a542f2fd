#include "engine/analyse/query/names_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire::query {
namespace {

constexpr unit::Dimension length_dimension{{1.0}};

std::string what_is_in(const std::string& unit) {
  return unit.empty() ? "a pure number" : unit == "m" ? "a length" : unit == "s" ? "a time" : "this";
}

std::optional<Formula> read_length_of(const yaml::Node& node, const std::string& text,
                                      const SymbolTable& names, const std::string& subject,
                                      yaml::Faults& faults) {
  auto formula = read_formula(node, text, 0, names, subject, faults);
  if (!formula || !formula->dimension || *formula->dimension == length_dimension ||
      *formula->dimension == unit::Dimension{})
    return formula;
  faults.add({{names.file, node.mark},
              subject,
              fmt::format("'{}' is in {}, but a length is wanted", text, unit::si_name(*formula->dimension)),
              {}});
  return std::nullopt;
}

std::vector<Formula> read_coordinates(const yaml::Node& node, const SymbolTable& names,
                                      const std::string& subject, yaml::Faults& faults) {
  std::vector<Formula> place;
  if (node.items.empty() || node.items.size() > max_coordinates)
    faults.add({{names.file, node.mark}, subject, "a point has one to three coordinates: [x, y]", {}});
  else
    for (const yaml::Node& item : node.items)
      if (auto formula = read_length(item, names, subject, faults)) place.push_back(std::move(*formula));
  return place.size() == node.items.size() ? place : std::vector<Formula>{};
}

/// Returns the names of vectors recorded as several columns: v for v.1, v.2.
std::vector<std::string> vectors_of(const SymbolTable& names) {
  std::vector<std::string> vectors;
  for (const RecordedName& column : names.columns)
    if (column.name.ends_with(".1")) vectors.push_back(column.name.substr(0, column.name.size() - 2));
  return vectors;
}

/// True for a name that is neither a column, a signal nor a number.
bool is_unknown_name(const std::string& text, const SymbolTable& names) {
  const auto of_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
         std::ranges::all_of(text, of_name) && !names.find(text) && !names.lacks(text);
}

}  // namespace

std::optional<Formula> NamesReading::formula(const yaml::Node& node) const {
  return read_formula(node, names, subject, faults);
}

std::optional<Series> NamesReading::series(const yaml::Node& node) const {
  return read_series(node, names, subject, faults);
}

void NamesReading::take(const yaml::Node& node, const yaml::Key&, std::optional<Formula>& member) const {
  member = formula(node);
}

void NamesReading::take(const yaml::Node& node, const yaml::Key&, std::optional<Series>& member) const {
  member = series(node);
}

void NamesReading::take(const yaml::Node& node, const yaml::Key&, std::vector<Series>& member) const {
  for (const yaml::Node& item : node.as_list())
    if (auto one = series(item)) member.push_back(std::move(*one));
}

void NamesReading::take(const yaml::Node& node, const yaml::Key& key, std::array<double, 2>& range) const {
  const auto* ends = pair(node, key);
  if (!ends) return;
  const auto low = number((*ends)[0], key.of.front()), high = number((*ends)[1], key.of.front());
  if (!low || !high) return;
  if (!(*low < *high)) fault(node.mark, "the first number of a range is below the second");
  range = {*low, *high};
}

std::optional<double> NamesReading::read_number(const yaml::Node& node, const yaml::Key& key) const {
  const auto number = stepwire::query::read_number(node, names, subject, faults);
  if (!number) return std::nullopt;
  check_dimension(*number, {unit::parse_unit(key.unit.empty() ? "1" : key.unit)->dimension, key.unit.empty()},
                  what_is_in(key.unit), node, names, subject, faults);
  return number->value;
}

const yaml::Key& series_form() {
  static const yaml::Key form = yaml::form::keys(
      "a series", "{signal: rig.x in mm, label: ...}",
      {yaml::needed(yaml::key("signal", "expression, with `in UNIT` behind it", yaml::form::expression())),
       yaml::key("label", "text at the axis or in the legend, without unit")});
  return form;
}

std::optional<Formula> read_length(const yaml::Node& node, const SymbolTable& names,
                                   const std::string& subject, yaml::Faults& faults) {
  if (!node.is_scalar()) return read_formula(node, names, subject, faults);
  return read_length_of(node, node.text, names, subject, faults);
}

std::vector<Formula> read_place(const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                                yaml::Faults& faults) {
  if (node.is_list()) return read_coordinates(node, names, subject, faults);
  std::vector<Formula> place;
  for (std::size_t i = 1; i <= max_coordinates; ++i) {
    const std::string element = fmt::format("{}.{}", node.text, i);
    if (names.find(element) == nullptr) break;
    if (auto formula = read_length_of(node, element, names, subject, faults))
      place.push_back(std::move(*formula));
  }
  if (!place.empty()) return place;
  if (is_unknown_name(node.text, names))
    faults.add({{names.file, node.mark},
                subject,
                fmt::format("'{}' is not recorded", node.text) +
                    yaml::nearest_or_all(node.text, vectors_of(names), "recorded vectors are"),
                {}});
  else if (auto formula = read_length(node, names, subject, faults))
    place.push_back(std::move(*formula));
  return place;
}

}  // namespace stepwire::query
