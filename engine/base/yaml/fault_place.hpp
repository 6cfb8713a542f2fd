#pragma once

#include <optional>
#include <string>
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

}  // namespace stepwire::yaml
