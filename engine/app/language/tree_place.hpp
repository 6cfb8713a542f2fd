#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// Key or value at an offset of a valid file, with its possible forms.
struct TreePlace {
  std::shared_ptr<const yaml::Document> document;
  const yaml::Entry* entry = nullptr;  ///< innermost entry whose key or value is at the offset
  bool on_key = false;
  FormList forms;                      ///< forms of the entry's value
  TextRange range{};                   ///< range of the key or scalar
  const yaml::Node* scalar = nullptr;  ///< scalar at the offset; nullptr on a key
};

std::optional<TreePlace> tree_place(DiagramFiles& files, const std::string& file, std::size_t offset);

}  // namespace stepwire::language
