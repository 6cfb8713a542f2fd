#include "engine/base/yaml/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "engine/base/yaml/choices.hpp"
#include "engine/base/yaml/message.hpp"

namespace stepwire::yaml {
namespace {

std::string limits_text(const Key& key) {
  const bool low = std::isfinite(key.least), high = std::isfinite(key.most);
  if (low && high && key.above)
    return fmt::format("above {} and at most {}{}{}", key.least, key.most, key.unit.empty() ? "" : " ",
                       key.unit);
  if (low && high) return fmt::format("from {} to {}", key.least, key.most);
  return high ? fmt::format("{} or less", key.most)
              : fmt::format(fmt::runtime(key.above ? "above {}" : "{} or more"), key.least);
}

/// Returns the nearest word, and all words with their explanations.
Message words_text(const std::string& written, const Key& key) {
  std::vector<std::string> all;
  for (const Key::Word& word : key.words)
    all.push_back(word.doc.empty() ? word.word : fmt::format("{} ({})", word.word, word.doc));
  Message text = did_you_mean(written, words_of(key));
  text.cure += fmt::format("{} one of: {}", text.empty() ? "it is" : " It is", fmt::join(all, ", "));
  return text;
}

bool within(double value, const Key& key) {
  return value <= key.most && (key.above ? value > key.least : value >= key.least);
}

}  // namespace

std::string default_text(const Key& key, double value) {
  return fmt::format("{}{}{}", value, key.unit.empty() ? "" : " ", key.unit);
}

std::string SectionReading::missing(const Key& key) {
  std::string text = fmt::format("'{}' is missing", key.name);
  if (!key.doc.empty()) text += fmt::format(" ({})", key.doc);
  return key.example.empty() ? text : fmt::format("{}; {}: {}", text, key.name, key.example);
}

std::string SectionReading::text(const Node& node) const {
  if (node.is_scalar() && !node.text.empty()) return node.text;
  fault(node.mark, "a text is wanted here");
  return {};
}

std::optional<std::size_t> SectionReading::word(const Node& node, const Key& key) const {
  const std::vector<std::string> words = words_of(key);
  const auto found = std::ranges::find(words, node.text);
  if (node.is_scalar() && found != words.end()) return static_cast<std::size_t>(found - words.begin());
  if (key.form == Key::Form::truth)
    fault(node.mark, fmt::format("'{}' is neither true nor false", node.text));
  else
    fault(node.mark, fmt::format("'{}' is not allowed", node.text) + words_text(node.text, key));
  return std::nullopt;
}

void SectionReading::take(const Node& node, const Key& key, std::string& member) const {
  if (key.words.empty())
    member = text(node);
  else if (const auto index = word(node, key))
    member = key.words[*index].word;
}

void SectionReading::take(const Node& node, const Key& key, double& member) const {
  if (const auto value = number(node, key)) member = *value;
}

void SectionReading::take(const Node& node, const Key& key, std::optional<double>& member) const {
  if (const auto value = number(node, key)) member = *value;
}

std::optional<double> SectionReading::read_number(const Node& node, const Key&) const {
  double value = 0.0;
  const char* const end = node.text.data() + node.text.size();
  const auto read = std::from_chars(node.text.data(), end, value);
  if (node.is_scalar() && !node.text.empty() && read.ptr == end && read.ec == std::errc{}) return value;
  fault(node.mark, fmt::format("'{}' is no number", node.text));
  return std::nullopt;
}

std::optional<double> SectionReading::whole(const Node& node, const Key& key) const {
  const auto value = read_number(node, key);
  if (!value) return std::nullopt;
  if (*value == std::floor(*value) && within(*value, key)) return value;
  fault(node.mark, fmt::format("'{}' is no whole number {}", node.text, limits_text(key)));
  return std::nullopt;
}

std::optional<double> SectionReading::number(const Node& node, const Key& key) const {
  const auto value = read_number(node, key);
  if (!value || within(*value, key)) return value;
  fault(node.mark, fault_text("{} is not allowed; it must be {}", node.text, limits_text(key)));
  return std::nullopt;
}

const std::vector<Node>* SectionReading::pair(const Node& node, const Key& key) const {
  if (node.is_list() && node.items.size() == 2) return &node.items;
  fault(node.mark, "takes two values: " + key.example);
  return nullptr;
}

bool SectionReading::check(const Node& map, const Key& keys) const {
  if (!map.is_map()) {
    fault(map.mark, fmt::format("{} is a map: {}", keys.noun, keys.example));
    return false;
  }
  const bool complete = !check_unknown(map, keys);  // an unknown key may be a misspelt required one
  for (const Key& key : keys.of)
    if (complete && key.required && !map.find(key.name))
      fault(map.mark, missing(key) + (key.example.empty() ? ": " + keys.example : ""));
  check_choices(map, keys, complete);
  if (complete) check_beside(map, keys);
  return true;
}

bool SectionReading::check_unknown(const Node& map, const Key& keys) const {
  bool found = false;
  for (const Entry& entry : map.entries) {
    if (!keys.rest.empty() || keys.find(entry.key)) continue;
    fault(entry.mark, unknown_key(entry.key, names_of(keys.of), keys.noun));
    found = true;
  }
  return found;
}

/// Returns the keys of one group alone.
static std::vector<std::string> names_of_choice(const Key& keys, const std::string& choice) {
  std::vector<std::string> names;
  for (const Key& key : keys.of)
    if (key.choice == choice) names.push_back(key.name);
  return names;
}

void SectionReading::check_choices(const Node& map, const Key& keys, bool missing_counts) const {
  std::map<std::string, std::vector<std::string>> choices;
  for (const Key& key : keys.of)
    for (const std::string& choice : choice_groups(key)) choices[choice].push_back(key.name);
  for (const auto& [choice, names] : choices) {
    const Entry* found = nullptr;
    for (const Entry& entry : map.entries) {
      if (std::ranges::find(names, entry.key) == names.end()) continue;
      if (found)
        fault(entry.mark,
              fault_text("both '{}' and '{}'; {} has one {}", found->key, entry.key, keys.noun, choice));
      else
        found = &entry;
    }
    if (!found && missing_counts)
      fault(map.mark, fmt::format("{} needs one {}: {}", keys.noun, choice,
                                  fmt::join(names_of_choice(keys, choice), ", ")));
  }
}

void SectionReading::check_beside(const Node& map, const Key& keys) const {
  for (const Entry& entry : map.entries) {
    const Key* key = keys.find(entry.key);
    if (!key || key->beside.empty()) continue;
    if (std::ranges::none_of(key->beside, [&](const std::string& other) { return map.find(other); }))
      sink_(entry.value.mark, below(*this, key->name).subject,
            fmt::format("'{}' goes with '{}' only", key->name, fmt::join(key->beside, "', '")));
  }
}

}  // namespace stepwire::yaml
