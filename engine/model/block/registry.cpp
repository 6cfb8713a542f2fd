#include "engine/model/block/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/model/block/symbol_check.hpp"

namespace stepwire {

void Registry::add(BlockType type) {
  check_symbol(type);
  if (const BlockType* known = find(type.name))
    throw std::logic_error(fmt::format("{}: a block is called {} already, that of {}", type.declared_at,
                                       type.name, known->declared_at));
  const std::string name = type.name;
  types_.emplace(name, std::make_unique<const BlockType>(std::move(type)));
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
