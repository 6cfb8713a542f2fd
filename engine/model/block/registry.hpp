#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/block/declare.hpp"

namespace stepwire {

/// The kinds of block that diagram files may use, by name.
class Registry {
 public:
  /// Adds a kind. Throws std::logic_error for a second one of its name, or a symbol that cannot be drawn.
  template <class Block>
  void add(std::string folder) {
    Declare<Block> declaration;
    Block::declare(declaration);
    BlockType type = declaration.take();
    type.folder = std::move(folder);
    add(std::move(type));
  }
  void add(BlockType type);

  const BlockType* find(std::string_view name) const;
  std::vector<std::string> names() const;
  std::vector<const BlockType*> types() const;

 private:
  std::map<std::string, std::unique_ptr<const BlockType>, std::less<>> types_;
};

}  // namespace stepwire
