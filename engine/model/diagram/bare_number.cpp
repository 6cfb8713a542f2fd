#include "engine/model/diagram/bare_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/base/unit/unit.hpp"

namespace stepwire::diagram {

bool is_scaled(const std::string& unit) {
  const auto parsed = unit::parse_unit(unit);
  return parsed && unit != "%" && (parsed->scale != 1.0L || parsed->offset != 0.0L);
}

std::optional<WrittenNumber> written_number(const yaml::Node& node) {
  if (!node.is_scalar() || !unit::parse_quantity(node.text)) return std::nullopt;
  const std::size_t sign = node.text.starts_with('+') ? 1 : 0;
  double number = 0.0;
  const char* const end = node.text.data() + node.text.size();
  const char* rest = std::from_chars(node.text.data() + sign, end, number).ptr;
  while (rest != end && *rest == ' ') ++rest;
  return WrittenNumber{number, std::string(rest, end)};
}

bool is_bare(const yaml::Node& node) {
  const auto written = written_number(node);
  return written && written->unit.empty() && written->number != 0.0 && std::isfinite(written->number);
}

std::string unit_as_written(const yaml::Node& node) {
  if (const auto written = written_number(node)) return written->unit;
  for (const yaml::Node& item : node.as_list())
    if (std::string unit = node.is_list() ? unit_as_written(item) : ""; !unit.empty()) return unit;
  return "";
}

std::optional<yaml::Message> bare_number(const std::string& text, const std::string& unit,
                                         const std::string& what) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = text;
  if (!is_scaled(unit) || !is_bare(node)) return std::nullopt;
  return yaml::fault_text("{} has no unit, but {} is in {}; write {} {}", text, what, unit, text, unit);
}

std::optional<yaml::Message> bare_element(const yaml::Node& list, const yaml::Node*& place) {
  const auto bare = std::ranges::find_if(list.items, is_bare);
  if (bare == list.items.end()) return std::nullopt;
  std::optional<unit::Dimension> common;
  const yaml::Node* scaled = nullptr;
  for (const yaml::Node& item : list.items) {
    const auto quantity = item.is_scalar() ? unit::parse_quantity(item.text) : std::nullopt;
    if (!quantity || !quantity->dimension) continue;
    if (common && *common != *quantity->dimension) return std::nullopt;
    common = quantity->dimension;
    if (!scaled && is_scaled(unit_as_written(item))) scaled = &item;
  }
  if (!scaled) return std::nullopt;
  place = &*bare;
  return yaml::fault_text("element {} is {}, which has no unit beside {}; give it one",
                          bare - list.items.begin() + 1, bare->text, scaled->text);
}

}  // namespace stepwire::diagram
