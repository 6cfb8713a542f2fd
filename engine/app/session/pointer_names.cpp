#include "engine/app/session/pointer_names.hpp"

#include <fmt/format.h>

#include "engine/model/diagram/named_signals.hpp"

namespace stepwire::session {

namespace {

using Names = std::map<std::string, diagram::SignalRef>;

/// Returns the fault of a name; std::nullopt if it is an output.
std::optional<yaml::Message> wrong_with(const std::string& name, const Names& names) {
  const auto found = names.find(name);
  if (found != names.end() && found->second.output >= 0) return std::nullopt;
  if (found != names.end()) return fmt::format("'{}' is a state; name an output of a block", name);
  std::vector<std::string> all;
  for (const auto& [known, signal] : names)
    if (signal.output >= 0) all.push_back(known);
  return fmt::format("there is no signal '{}'", name) + yaml::did_you_mean(name, all);
}

}  // namespace

void check_pointer_names(const diagram::Diagram& diagram, yaml::Faults& faults) {
  const yaml::Node* pointer = diagram.scene.find("pointer");
  if (!pointer) return;
  const Names names = diagram::named_signals(diagram);
  const auto check = [&](const std::string& key, const yaml::Node& node) {
    if (node.kind != yaml::Node::Kind::scalar) return;  // the form check has reported this
    if (const auto wrong = wrong_with(node.text, names))
      faults.add({{diagram.file, node.mark}, "scene.pointer." + key, *wrong, {}});
  };
  for (const yaml::Entry& entry : pointer->entries) {
    check(entry.key, entry.value);
    for (const yaml::Node& item : entry.value.items) check(entry.key, item);
  }
}

}  // namespace stepwire::session
