#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// A key or a value that stands at a place of a file which can be read, with what may stand there.
struct TreePlace {
  std::shared_ptr<const yaml::Document> document;
  const yaml::Entry* entry = nullptr;  ///< the innermost whose key or value is there
  bool on_key = false;
  FormList forms;                      ///< of the entry's value
  TextRange range{};                   ///< of the key, or of the scalar
  const yaml::Node* scalar = nullptr;  ///< at the place; null on a key
};

std::optional<TreePlace> tree_place(DiagramFiles& files, const std::string& file, std::size_t offset);

}  // namespace stepwire::language
