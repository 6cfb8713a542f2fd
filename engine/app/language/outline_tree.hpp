#pragma once

#include <string>
#include <vector>

#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

/// Item in the outline of a file: a section, or a block, parameter, port or claim within one.
struct OutlineItem {
  enum class Kind { section, block, part, parameter, port, claim };
  std::string name;
  std::string detail;
  Kind kind;
  EditorRange range;  ///< range of the whole item
  EditorRange name_range;
  std::vector<OutlineItem> children;
};

std::vector<OutlineItem> outline_of(const yaml::Document& document, std::string_view text);

}  // namespace stepwire::language
