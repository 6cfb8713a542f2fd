#include "engine/model/diagram/part_alone.hpp"

#include <algorithm>
#include <filesystem>

#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/written.hpp"

namespace stepwire::diagram {

bool is_part(const yaml::Node& root) {
  if (!root.find("stop")) return true;
  if (const yaml::Node* inputs = root.find("inputs"))
    for (const yaml::Entry& input : inputs->entries)
      if (!input.value.is_map() || !input.value.find("default")) return true;
  return false;
}

bool is_other_map(const yaml::Node& root) {
  return root.is_map() && !root.entries.empty() &&
         std::ranges::none_of(root.entries,
                              [](const yaml::Entry& entry) { return head_form().find(entry.key); });
}

yaml::Document user_of_part(const std::string& path, const yaml::Node& part) {
  yaml::Node keys;
  add_key(keys, "diagram", written_filled_in(std::filesystem::path(path).filename().string()));
  if (const yaml::Node* inputs = part.find("inputs"))
    for (const yaml::Entry& input : inputs->entries) add_key(keys, input.key, written_text("0"));
  yaml::Document user{path + " alone", {}};
  add_key(user.root, "stepwire", written_text("1"));
  add_key(user.root, "step", written_text("1"));
  add_key(user.root, "stop", written_text("1"));
  yaml::Node blocks;
  add_key(blocks, "part", std::move(keys));
  add_key(user.root, "blocks", std::move(blocks));
  return user;
}

}  // namespace stepwire::diagram
