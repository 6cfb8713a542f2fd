#include "engine/model/diagram/bus_fields.hpp"

#include <charconv>

namespace stepwire::diagram {

namespace {

/// Reads the unit and shape of a field.
BusField described(const std::string& name, const yaml::Entry& entry) {
  BusField field{name, nullptr, -1, {}, {}, entry.mark};
  if (!entry.value.is_map()) return field;
  if (const yaml::Node* unit = entry.value.find("unit"))
    if (const auto parsed = unit::parse_unit(unit->text)) field.dimension = parsed->dimension;
  if (const yaml::Node* shape = entry.value.find("shape")) field.shape = parse_shape(shape->text);
  return field;
}

void add_written(const yaml::Node& map, const std::string& prefix, BusFields& fields) {
  const yaml::Node* inside = map.find("fields");
  for (const yaml::Entry& entry : (inside ? *inside : map).entries) {
    const yaml::Node& value = entry.value;
    const yaml::Node* signal = value.is_map() ? value.find("signal") : nullptr;
    if (value.is_map() && !signal && !value.find("value")) {
      add_written(value, prefix + entry.key + ".", fields);
    } else {
      fields.push_back(described(prefix + entry.key, entry));
      fields.back().signal = signal ? signal : &value;
    }
  }
}

void add_declared(const yaml::Node& map, const std::string& prefix, BusFields& fields) {
  const yaml::Node* inside = map.find("fields");
  for (const yaml::Entry& entry : (inside ? *inside : map).entries) {
    const yaml::Node& value = entry.value;
    const bool is_leaf = !value.is_map() || value.find("unit") || value.find("shape") || value.find("doc");
    if (!is_leaf) {
      add_declared(value, prefix + entry.key + ".", fields);
      continue;
    }
    fields.push_back(described(prefix + entry.key, entry));
    if (!value.is_scalar() || value.text.empty()) continue;
    if (const auto unit = unit::parse_unit(value.text)) fields.back().dimension = unit->dimension;
  }
}

}  // namespace

BusFields written_fields(const yaml::Node& map) {
  BusFields fields;
  add_written(map, "", fields);
  return fields;
}

BusFields declared_fields(const yaml::Node& map) {
  BusFields fields;
  add_declared(map, "", fields);
  return fields;
}

std::optional<std::pair<Eigen::Index, Eigen::Index>> parse_shape(const std::string& text) {
  const char* const end = text.data() + text.size();
  Eigen::Index rows = 0, columns = 1;
  const auto high = std::from_chars(text.data(), end, rows);
  if (high.ec != std::errc() || rows < 1) return std::nullopt;
  if (high.ptr == end) return std::pair(rows, columns);
  if (!std::string_view(high.ptr, end).starts_with(" x ")) return std::nullopt;
  const auto wide = std::from_chars(high.ptr + 3, end, columns);
  if (wide.ec != std::errc() || wide.ptr != end || columns < 1) return std::nullopt;
  return std::pair(rows, columns);
}

std::vector<std::string> names_below(const std::vector<std::string>& names, const std::string& start) {
  if (start.empty()) return names;
  std::vector<std::string> below;
  for (const std::string& name : names)
    if (name.starts_with(start + ".")) below.push_back(name.substr(start.size() + 1));
  return below;
}

}  // namespace stepwire::diagram
