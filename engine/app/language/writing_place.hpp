#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// Context of the cursor in a text that need not be valid YAML.
struct WritingPlace {
  /// Document of the text with a name inserted at the cursor; it owns `map`.
  std::shared_ptr<const yaml::Document> document;
  FormList keys;                    ///< Maps of which a key is possible here; may be empty.
  FormList values;                  ///< Possible forms of the value.
  const yaml::Node* map = nullptr;  ///< Map that contains the key or value; nullptr if none.
  std::string key;                  ///< Key of the value.
  std::string block;                ///< Name of the enclosing block.
  std::string before;               ///< Text of the scalar before the cursor.
  TextRange word;                   ///< Name around the cursor, with its dots.
  TextRange scalar;                 ///< Whole scalar without quotes.
};

/// Returns the context of an offset; std::nullopt if no trial text is valid YAML.
/// Problem: the text around a cursor is seldom valid YAML. Idea: a probe name is inserted at the cursor, and
/// several trial texts are parsed, for example with the open brackets closed. The probe is found in the first
/// valid tree, and its ancestors determine the possible forms. Cost: at most eight parses.
std::optional<WritingPlace> writing_place(DiagramFiles& files, const std::string& file, std::size_t offset);

}  // namespace stepwire::language
