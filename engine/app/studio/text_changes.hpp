#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stepwire::studio {

/// A piece of a text that is replaced. Places count units of UTF-16, as browsers do.
struct TextChange {
  std::size_t from = 0, to = 0;
  std::string text{};

  bool operator==(const TextChange&) const = default;
};

/// Units of UTF-16 of a UTF-8 text.
std::size_t utf16_length(std::string_view text);

/// The text with all changes in it, whose places all lie in the text as it was. Throws Fault for places that
/// are not in the text or inside of a character, and for changes that overlap.
std::string changed(std::string_view text, std::vector<TextChange> changes);

/// Does a text consist of UTF-8 characters?
bool is_utf8(std::string_view text);

}  // namespace stepwire::studio
