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

Change read_change(const yaml::Node& node) {
  Change change;
  for (const yaml::Entry& entry : node.entries)
    if (!std::set<std::string>{"change", "in", "replace", "set", "fails"}.contains(entry.key))
      throw std::runtime_error(
          fmt::format("line {}: '{}' is no key of a change", entry.mark.line, entry.key));
  change.what = node.find("change") ? node.find("change")->text : "";
  if (const yaml::Node* in = node.find("in")) change.in = in->text;
  change.replaced = pairs_of(node.find("replace"));
  for (const auto& [name, value] : pairs_of(node.find("set"))) change.settings.push_back({name, value});
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
