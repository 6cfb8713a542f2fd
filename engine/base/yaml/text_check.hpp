#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

/// What makes a text no text: where, and what is wrong with it.
struct TextFault {
  Mark mark;
  std::string message;
};

/// The first byte that no YAML file can have: a control character, or what is not UTF-8. Nothing if the text
/// is sound.
std::optional<TextFault> check_text(std::string_view text);

}  // namespace stepwire::yaml
