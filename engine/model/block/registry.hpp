#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/model/block/declare.hpp"

namespace stepwire {

/// Registered kinds of blocks, by name.
class Registry {
 public:
  /// Adds a kind. Throws std::logic_error for a duplicate name or a symbol that cannot be drawn.
  template <class Block>
  void add(std::string folder) {
    Declare<Block> declaration;
    Block::declare(declaration);
    BlockType type = declaration.take();
    type.folder = std::move(folder);
    add(std::move(type));
  }
  void add(BlockType type);
  /// Records an external folder whose blocks are registered.
  void note_blockset(std::string folder) { blocksets_.push_back(std::move(folder)); }
  /// Returns these folders, in the order of registration.
  const std::vector<std::string>& blocksets() const { return blocksets_; }

  const BlockType* find(std::string_view name) const;
  std::vector<std::string> names() const;
  std::vector<const BlockType*> types() const;

 private:
  std::map<std::string, std::unique_ptr<const BlockType>, std::less<>> types_;
  std::vector<std::string> blocksets_;
};

}  // namespace stepwire
