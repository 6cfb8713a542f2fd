#include "engine/model/block/registry.hpp"

#include <stdexcept>

#include "engine/model/block/symbol_check.hpp"

namespace stepwire {

void Registry::add(BlockType type) {
  check_symbol(type);
  const std::string name = type.name;
  const bool added = types_.emplace(name, std::make_unique<const BlockType>(std::move(type))).second;
  if (!added) throw std::logic_error("two blocks are called " + name);
}

const BlockType* Registry::find(std::string_view name) const {
  const auto found = types_.find(name);
  return found == types_.end() ? nullptr : found->second.get();
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> result;
  for (const auto& [name, type] : types_) result.push_back(name);
  return result;
}

std::vector<const BlockType*> Registry::types() const {
  std::vector<const BlockType*> result;
  for (const auto& [name, type] : types_) result.push_back(type.get());
  return result;
}

}  // namespace stepwire
