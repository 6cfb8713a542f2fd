#include "engine/analyse/study/section_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/analyse/query/number.hpp"

namespace stepwire {

SectionKeys::SectionKeys(const std::string& section, const Node& node, const std::string& file,
                         const std::vector<std::string>& known, Loader& loader, Faults& faults)
    : section_(section), place_{file, node.mark}, known_(known), loader_(loader), faults_(faults) {
  take(node, file);
}

void SectionKeys::take(const Node& node, const std::string& file) {
  if (!files_.insert(file).second)
    return add(file, node.mark, section_ + ".like", "this section is like itself in the end");
  if (!node.is_map()) return add(file, node.mark, section_, "is a map of keys and values");
  for (const Entry& entry : node.entries) {
    if (std::find(known_.begin(), known_.end(), entry.key) == known_.end())
      add(file, entry.mark, section_,
          fmt::format("there is no key '{}' here{}", entry.key,
                      nearest_or_all(entry.key, known_, "there are")));
    else if (!find(entry.key) && entry.key != "like")
      keys_.push_back({entry.key, file, entry.mark, &entry.value});
  }
  if (const Node* like = node.find("like")) take_from(*like, file);
}

void SectionKeys::take_from(const Node& like, const std::string& file) {
  const std::string path =
      (std::filesystem::path(file).parent_path() / like.text).lexically_normal().string();
  const Node* section = nullptr;
  try {
    section = loader_.document(path).root.find(section_);
  } catch (const Error& error) {
    return add(file, like.mark, section_ + ".like", error.faults().front().text());
  }
  if (section) return take(*section, path);
  add(file, like.mark, section_ + ".like", fmt::format("{} has no section '{}'", path, section_));
}

const SectionKeys::Key* SectionKeys::find(const std::string& name) const {
  const auto found =
      std::find_if(keys_.begin(), keys_.end(), [&](const Key& key) { return key.name == name; });
  return found == keys_.end() ? nullptr : &*found;
}

const SectionKeys::Key* SectionKeys::required(const std::string& name, const std::string& form) {
  const Key* key = find(name);
  if (!key) fault(fmt::format("'{0}' is missing; {0}: {1}", name, form));
  return key;
}

std::optional<std::size_t> SectionKeys::whole(const Node& node, double least, double most) {
  const auto value = parse_quantity(node.text);
  if (value && !value->dimension && value->value == std::floor(value->value) && value->value >= least &&
      value->value <= most)
    return static_cast<std::size_t>(value->value);
  return std::nullopt;
}

std::uint64_t SectionKeys::whole(const std::string& name, double least, double most,
                                 std::uint64_t otherwise) {
  const Key* key = find(name);
  if (!key) return otherwise;
  const auto value = whole(*key->node, least, most);
  if (!value) fault(*key, fmt::format("'{}' is no whole number from {} to {}", key->node->text, least, most));
  return value.value_or(otherwise);
}

void SectionKeys::fault(const Key& key, const Mark& mark, const std::string& below,
                        const std::string& message) {
  add(key.file, mark, fmt::format("{}.{}{}{}", section_, key.name, below.empty() ? "" : ".", below), message);
}

void SectionKeys::fault(const std::string& message) {
  add(place_.file, place_.mark, section_, message);
}

void SectionKeys::add(const std::string& file, const Mark& mark, const std::string& subject,
                      const std::string& message) {
  faults_.add({{file, mark}, subject, message, {}});
}

}  // namespace stepwire
