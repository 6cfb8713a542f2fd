#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::yaml {

/// Parts of a tree at a mark.
struct FoundPlace {
  std::vector<std::string> keys;  ///< path to it
  const Entry* key = nullptr;     ///< begins at the mark; nullptr without one
  const Node* value = nullptr;    ///< innermost value that begins at the mark; nullptr without one
  const Node* around = nullptr;   ///< scalar that contains the mark; nullptr without one
};

FoundPlace find_place(const Node& root, const Mark& mark);

/// Returns the end of the text that a fault refers to. That is a key, a scalar, the first line of a list or
/// map, or the unknown word inside of a scalar. Returns std::nullopt where the tree has no value at the
/// fault.
std::optional<Mark> end_of_fault(const Node& root, const Fault& fault);

/// Finds a whole word in the bytes [from, to) of a text: no letter, digit or '_' precedes or follows it. The
/// word of a suggestion replaces it.
std::optional<std::size_t> find_word(std::string_view text, std::size_t from, std::size_t to,
                                     const std::string& word);

}  // namespace stepwire::yaml
