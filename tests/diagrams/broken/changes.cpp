#include "tests/diagrams/broken/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "engine/base/io/file.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::broken {

namespace {

Texts pairs_of(const yaml::Node* node) {
  Texts pairs;
  if (node)
    for (const yaml::Entry& entry : node->entries) pairs.emplace_back(entry.key, entry.value.text);
  return pairs;
}

std::vector<diagram::Setting> settings_of(const yaml::Node* node) {
  std::vector<diagram::Setting> settings;
  for (const auto& [name, value] : pairs_of(node)) settings.push_back({name, value});
  return settings;
}

void check_keys(const yaml::Node& node, const std::set<std::string>& known, const std::string& of) {
  for (const yaml::Entry& entry : node.entries)
    if (!known.contains(entry.key))
      throw std::runtime_error(fmt::format("line {}: '{}' is no key of {}", entry.mark.line, entry.key, of));
}

Cut read_cut(const yaml::Node& node) {
  check_keys(node, {"replace", "set"}, "a cut");
  return {pairs_of(node.find("replace")), settings_of(node.find("set"))};
}

Change read_change(const yaml::Node& node) {
  Change change;
  check_keys(node, {"change", "in", "cut", "replace", "set", "fails"}, "a change");
  change.what = node.find("change") ? node.find("change")->text : "";
  if (const yaml::Node* in = node.find("in")) change.in = in->text;
  if (const yaml::Node* cut = node.find("cut")) change.cut = read_cut(*cut);
  change.replaced = pairs_of(node.find("replace"));
  change.settings = settings_of(node.find("set"));
  if (const yaml::Node* fails = node.find("fails"))
    for (const yaml::Node& item : fails->items) change.fails.push_back(item.text);
  if (change.what.empty() || change.fails.empty() || (change.replaced.empty() && change.settings.empty()))
    throw std::runtime_error(
        fmt::format("line {}: a change has 'change', 'fails', and 'replace' or 'set'", node.mark.line));
  return change;
}

}  // namespace

bool Broken::lists(const Texts& listed, const std::string& name) {
  return std::ranges::any_of(listed,
                             [&](const auto& one) { return one.first == name && !one.second.empty(); });
}

Broken read_broken(const std::string& file) {
  const yaml::Document document = yaml::parse_document(io::read_file(file), file);
  Broken broken;
  broken.always = pairs_of(document.root.find("always"));
  if (const yaml::Node* changes = document.root.find("changes"))
    for (const yaml::Node& item : changes->items) broken.changes.push_back(read_change(item));
  broken.unmoved = pairs_of(document.root.find("unmoved"));
  broken.unseen = pairs_of(document.root.find("unseen"));
  return broken;
}

}  // namespace stepwire::broken
