#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Returns all blocks by folder, both in alphabetical order.
inline std::map<std::string, std::vector<const BlockType*>> families_of(const Registry& registry) {
  std::map<std::string, std::vector<const BlockType*>> families;
  for (const BlockType* type : registry.types()) families[type->folder].push_back(type);
  return families;
}

}  // namespace stepwire::reference
