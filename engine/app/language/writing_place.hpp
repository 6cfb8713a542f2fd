#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// What is being written at a place of a text that need not be YAML yet.
struct WritingPlace {
  /// The text as it would be with a name at the cursor; what `map` is in.
  std::shared_ptr<const yaml::Document> document;
  FormList keys;                    ///< maps of which a key may stand here; empty where none may
  FormList values;                  ///< forms of the value that may stand here
  const yaml::Node* map = nullptr;  ///< in which the key or value stands; null where there is none
  std::string key;                  ///< whose value it is
  std::string block;                ///< in whose map it stands
  std::string before;               ///< of the scalar, up to the cursor
  TextRange word;                   ///< the name around the cursor, with its dots, in the text
  TextRange scalar;                 ///< all of it, without quotes
};

/// Nothing where the text around the cursor cannot be made YAML by a name and closing brackets.
std::optional<WritingPlace> writing_place(DiagramFiles& files, const std::string& file, std::size_t offset);

}  // namespace stepwire::language
