// Buses: named groups of signals, written in a file like a block.
#include <fmt/format.h>

#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/bus_stores.hpp"
#include "engine/model/diagram/keys.hpp"
#include "engine/model/diagram/open.hpp"

namespace stepwire::diagram {

namespace {

/// Refuses invalid fields, and invalid properties of fields.
void check_fields(const Scope& scope, const std::string& bus, const yaml::Node& map, Report& report) {
  if (!map.is_map() || map.entries.empty())
    return report.add(scope.at(map.mark), bus, "a bus has fields, as {fields: {force: f, torque: t}}");
  for (const yaml::Entry& entry : map.entries) {
    const std::string field = bus + "." + entry.key;
    if (!is_name(entry.key))
      report.add(scope.at(entry.mark), field, "is no name for a field; use letters, digits and '_'");
    if (!entry.value.is_map() || entry.value.find("value")) continue;
    if (const yaml::Node* inside = entry.value.find("fields")) {
      check_fields(scope, field, *inside, report);
      continue;
    }
    const yaml::Node *unit = entry.value.find("unit"), *shape = entry.value.find("shape");
    if (unit && !unit::parse_unit(unit->text))
      report.add(scope.at(unit->mark), field, yaml::fault_text("'{}' is no unit", unit->text));
    if (shape && !parse_shape(shape->text))
      report.add(scope.at(shape->mark), field,
                 yaml::fault_text("'{}' is no shape; write 3, or 3 x 2 for a matrix of 3 rows", shape->text));
  }
}

}  // namespace

void Opener::make_bus(Scope& scope, const yaml::Entry& entry) {
  for (const yaml::Entry& key : entry.value.entries)
    if (key.key != "fields" && key.key != "doc")
      report_.add(scope.at(key.mark), scope.prefix + entry.key,
                  yaml::fault_text("a bus has no '{}'; it has 'fields:'", key.key));
  const yaml::Node& fields = *entry.value.find("fields");
  check_fields(scope, scope.prefix + entry.key, fields, report_);
  if (!fields.is_map() || fields.entries.empty()) {
    scope.failed.insert(entry.key);
    return;
  }
  scope.names[entry.key] = {-1, nullptr, entry.mark, written_fields(entry.value)};
}

void Opener::copy_for_buses(Scope& root) {
  copy_blocks_for_buses(root, pending_, written_, report_);
}

}  // namespace stepwire::diagram
