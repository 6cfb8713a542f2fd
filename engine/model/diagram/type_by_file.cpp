#include "engine/model/diagram/type_by_file.hpp"

#include <optional>
#include <stdexcept>

#include "engine/base/yaml/message.hpp"
#include "engine/model/block/typed_by_file.hpp"

namespace stepwire::diagram {

const BlockType* type_by_file(const BlockType& type, const yaml::Node& map, const ValueReader& reader,
                              Report& report, const std::string& subject) {
  const TypeOfFile of = find_typed_by_file(type.name);
  const ParameterSpec* spec = type.parameter("file");
  const yaml::Node* file = map.find("file");
  if (!of || !spec || !file) return &type;
  const auto path = reader.read_for(*spec, {}, *file, subject + ".file");
  if (!path) return nullptr;
  const yaml::Node* interface = map.find("interface");
  const auto word = interface ? reader.fill_in(*interface, subject + ".interface") : std::optional<std::string>("");
  if (!word) return nullptr;
  try {
    return &of(*path->value.text(), *word);
  } catch (const std::runtime_error& error) {
    report.add(reader.at(file->mark), subject + ".file", yaml::fault_text("{}", error.what()));
    return nullptr;
  }
}

}  // namespace stepwire::diagram
