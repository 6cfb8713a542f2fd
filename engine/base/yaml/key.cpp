#include "engine/base/yaml/key.hpp"

#include <algorithm>
#include <utility>

namespace stepwire::yaml {

const Key* Key::find(const std::string& key) const {
  const auto found = std::ranges::find(of, key, &Key::name);
  return found == of.end() ? nullptr : &*found;
}

std::vector<std::string> words_of(const Key& key) {
  std::vector<std::string> words;
  for (const Key::Word& word : key.words) words.push_back(word.word);
  return words;
}

std::vector<std::string> names_of(const std::vector<Key>& keys) {
  std::vector<std::string> names;
  for (const Key& key : keys) names.push_back(key.name);
  return names;
}

Key form::word(std::vector<std::string> words) {
  Key key = of(Form::word);
  for (std::string& one : words) key.words.push_back({std::move(one)});
  return key;
}

Key form::above_zero(Key number) {
  number.least = 0.0;
  number.above = true;
  return number;
}

Key key(std::string name, std::string doc, Key form) {
  form.name = std::move(name);
  form.doc = std::move(doc);
  return form;
}

Key like(std::string example, Key form) {
  form.example = std::move(example);
  return form;
}

}  // namespace stepwire::yaml
