#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

/// Location of invalid text, and the message about it.
struct TextFault {
  Mark mark;
  std::string message;
};

/// Returns the first byte that YAML does not allow, a control character or invalid UTF-8; std::nullopt for a
/// valid text.
std::optional<TextFault> check_text(std::string_view text);

}  // namespace stepwire::yaml
