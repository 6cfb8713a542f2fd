#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/document/place.hpp"

namespace stepwire {

/// What makes a text no text: where, and what is wrong with it.
struct TextFault {
  Mark mark;
  std::string message;
};

/// The first byte that no YAML file can have: a control character, or what is not UTF-8. Nothing if the text
/// is sound.
std::optional<TextFault> check_text(std::string_view text);

/// Length in bytes of the UTF-8 character at the start of `text`; 0 if it is none.
std::size_t utf8_length(std::string_view text);

}  // namespace stepwire
