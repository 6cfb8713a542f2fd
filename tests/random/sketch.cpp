#include "tests/random/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace stepwire::random {

namespace {

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

void add_section(std::string& text, const char* name, const std::vector<Key>& keys) {
  if (keys.empty()) return;
  text += fmt::format("{}:\n", name);
  for (const Key& key : keys) text += fmt::format("  {}: {}\n", key.name, key.value);
}

std::string line_of(const Entry& entry) {
  std::string keys;
  for (const Key& key : entry.keys)
    keys += fmt::format("{}{}: {}", keys.empty() ? "" : ", ", key.name, key.value);
  return fmt::format("  {}: {{{}}}\n", entry.name, keys);
}

}  // namespace

const std::string* Entry::find(const std::string& key) const {
  const auto found = std::ranges::find(keys, key, &Key::name);
  return found == keys.end() ? nullptr : &found->value;
}

std::string text_of(const Sketch& sketch) {
  std::string text = "stepwire: 1\ntitle: a random diagram\n";
  for (const Key& key : sketch.head) text += fmt::format("{}: {}\n", key.name, key.value);
  add_section(text, "parameters", sketch.parameters);
  add_section(text, "inputs", sketch.inputs);
  add_section(text, "outputs", sketch.outputs);
  add_section(text, "units", sketch.units);
  text += "blocks:\n";
  for (const Entry& entry : sketch.blocks) text += line_of(entry);
  return text;
}

std::string with_words(const std::string& text, const std::function<std::string(const std::string&)>& other) {
  std::string made;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_of_word(text[end])) ++end;
    made += end > at ? other(text.substr(at, end - at)) : std::string(1, text[at]);
    at = std::max(end, at + 1);
  }
  return made;
}

bool has_word(const std::string& text, const std::string& word) {
  bool found = false;
  with_words(text, [&](const std::string& one) {
    found = found || one == word;
    return one;
  });
  return found;
}

void change_words(Entry& entry, const std::function<std::string(const std::string&)>& other) {
  for (Key& key : entry.keys) key.value = with_words(key.value, other);
}

}  // namespace stepwire::random
