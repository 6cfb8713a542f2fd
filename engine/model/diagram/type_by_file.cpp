#include "engine/model/diagram/type_by_file.hpp"

#include <optional>
#include <stdexcept>

#include "engine/base/yaml/message.hpp"
#include "engine/model/block/typed_by_file.hpp"
#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

namespace {

const BlockType* read(const BlockType& type, TypeOfFile of, const yaml::Entry& entry, const Scope& scope,
                      Report& report) {
  const ValueReader reader(scope.parameters, report, scope.index);
  const std::string subject = scope.prefix + entry.key;
  const yaml::Node& file = *entry.value.find("file");
  const yaml::Node* interface = entry.value.find("interface");
  const auto path = reader.read_for(*type.parameter("file"), {}, file, subject + ".file");
  const auto word =
      interface ? reader.fill_in(*interface, subject + ".interface") : std::optional<std::string>("");
  if (!path || !word) return nullptr;
  try {
    return &of(*path->value.text(), *word);
  } catch (const std::runtime_error& error) {
    report.add(reader.at(file.mark), subject + ".file", yaml::fault_text("{}", error.what()));
    return nullptr;
  }
}

}  // namespace

const BlockType* type_by_file(const BlockType& type, const yaml::Entry& entry, Scope& scope, Report& report) {
  const TypeOfFile of = find_typed_by_file(type.name);
  if (!of || !type.parameter("file") || !entry.value.find("file")) return &type;
  const BlockType* found = read(type, of, entry, scope, report);
  if (!found) scope.failed.insert(entry.key);
  return found;
}

}  // namespace stepwire::diagram
