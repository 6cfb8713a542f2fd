#include "engine/analyse/query/names_reading.hpp"

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire::query {
namespace {

std::string what_is_in(const std::string& unit) {
  return unit.empty() ? "a pure number" : unit == "m" ? "a length" : unit == "s" ? "a time" : "this";
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
  check_dimension(*number, unit::parse_unit(key.unit.empty() ? "1" : key.unit)->dimension,
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

}  // namespace stepwire::query
