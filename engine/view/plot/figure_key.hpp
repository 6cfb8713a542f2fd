#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire {

struct Names;

/// What stands behind a key of a figure.
enum class ValueType {
  text,
  expression,
  series,       ///< an expression in a unit, perhaps with a label
  number,       ///< with a unit or without
  whole,        ///< a whole number between limits
  truth,        ///< true or false
  word,         ///< one of some words
  number_pair,  ///< two numbers
  size_pair,    ///< two whole numbers
  points,       ///< map of name: [x, y]
  point_list,   ///< the same, or a list of [x, y]
  text_map,     ///< map of name: text
  name_map,     ///< map of name: text or list of texts
  map,          ///< with the keys of the row
  panels,
  tree  ///< what only the explanation describes
};

/// A key of figures as a row of a table: reader, schema and reference come from it.
struct FigureKey {
  std::string name;
  std::string doc;
  ValueType type = ValueType::text;
  bool list = false;                 ///< one value, or a list of them
  std::vector<std::string> words{};  ///< that are allowed
  std::vector<FigureKey> keys{};     ///< of a map
  bool required = false;             ///< in its map
  int low = 0, high = 0;             ///< limits of a whole number
};

/// What the keys of a file are read with.
struct KeyReading {
  const Names& names;
  Faults& faults;

  void fault(Mark mark, const std::string& key, const std::string& message) const;
  /// A text, one of the words or a number; a fault and nothing where it is none.
  std::string text(const Node& node, const std::string& key) const;
  std::optional<std::size_t> word(const Node& node, const FigureKey& key) const;
  std::optional<int> whole(const Node& node, const FigureKey& key) const;
};

/// What a key needs of its plot.
enum class KeyNeeds {
  nothing,
  plane,  ///< axes in a plane
  both    ///< axes in a plane, and something along both
};

/// When a key is read.
enum class KeyStage {
  options,  ///< with the units of the axes
  points,   ///< behind the ranges, within which it lies
  rows      ///< behind the recordings of the panel, whose rows it reads
};

/// A row with what it sets in a panel or a picture.
template <class Target>
struct KeyOf : FigureKey {
  std::function<void(Target&, const Node&, const KeyReading&)> set{};
  KeyNeeds needs = KeyNeeds::nothing;
  KeyStage stage = KeyStage::options;
};

/// The items of a list, or the one node.
inline std::vector<Node> items_of(const Node& node) {
  return node.is_list() ? node.items : std::vector<Node>{node};
}

template <class Target>
KeyOf<Target> text_key(std::string name, std::string doc, std::string Target::*member) {
  return {{name, std::move(doc)}, [=](Target& target, const Node& node, const KeyReading& read) {
            target.*member = read.text(node, name);
          }};
}

/// The member has the index of the word: a bool or an enum.
template <class Target, class Member>
KeyOf<Target> word_key(std::string name, std::string doc, std::vector<std::string> words,
                       Member Target::*member) {
  const FigureKey row{std::move(name), std::move(doc), ValueType::word, false, std::move(words)};
  return {row, [=](Target& target, const Node& node, const KeyReading& read) {
            if (const auto index = read.word(node, row)) target.*member = static_cast<Member>(*index);
          }};
}

template <class Target>
KeyOf<Target> truth_key(std::string name, std::string doc, bool Target::*member) {
  auto key = word_key(std::move(name), std::move(doc), {"false", "true"}, member);
  key.type = ValueType::truth;
  return key;
}

}  // namespace stepwire
