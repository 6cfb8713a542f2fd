#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace stepwire::random {

/// A key of a YAML map and its value as text on one line.
struct Key {
  std::string name, value;
};

/// A block, a part or a bus: its keys in their order.
struct Entry {
  std::string name;
  std::vector<Key> keys;

  const std::string* find(const std::string& key) const;
};

/// A diagram file in pieces, so that it can be reordered, renamed, made smaller. Names of blocks are words
/// that occur in values as references alone.
struct Sketch {
  std::vector<Key> head;  ///< step, stop, solver, ...
  std::vector<Key> parameters, units, inputs, outputs;
  std::vector<Entry> blocks;
  std::map<std::string, Sketch> parts;  ///< by the names of their files
};

/// The file as text; its parts are files of their own.
std::string text_of(const Sketch& sketch);

/// Replaces each word of a text by what `other` returns for it.
std::string with_words(const std::string& text, const std::function<std::string(const std::string&)>& other);
/// True where a text has this word.
bool has_word(const std::string& text, const std::string& word);
/// Replaces words in all values of an entry.
void change_words(Entry& entry, const std::function<std::string(const std::string&)>& other);

}  // namespace stepwire::random
