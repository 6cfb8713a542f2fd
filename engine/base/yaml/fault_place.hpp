#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::yaml {

/// What stands at a mark of a tree.
struct FoundPlace {
  std::vector<std::string> keys;  ///< that lead there
  const Entry* key = nullptr;     ///< that begins at the mark
  const Node* value = nullptr;    ///< the innermost that begins at the mark
  const Node* around = nullptr;   ///< the scalar that holds the mark
};

FoundPlace find_place(const Node& root, const Mark& mark);

/// Just behind what a fault is about: a key, a scalar, of a list or a map what stands in its first line, and
/// inside of a scalar the word that means nothing. Nothing where the tree has nothing there.
std::optional<Mark> end_of_fault(const Node& root, const Fault& fault);

/// Where a word stands for itself in a piece of a text, positions in bytes: no letter, digit or '_' goes on
/// before or behind it. That is what the word of a suggestion takes the place of.
std::optional<std::size_t> find_word(std::string_view text, std::size_t from, std::size_t to,
                                     const std::string& word);

}  // namespace stepwire::yaml
