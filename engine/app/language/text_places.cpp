#include "engine/app/language/text_places.hpp"

#include <algorithm>

#include "engine/base/text/characters.hpp"

namespace stepwire::language {

namespace {

/// Units of UTF-16 of a character that has so many bytes in UTF-8.
int utf16_units(std::size_t bytes) {
  return bytes == 4 ? 2 : 1;
}

std::size_t next(std::string_view text, std::size_t at) {
  return std::max<std::size_t>(1, text::utf8_length(text.substr(at)));
}

}  // namespace

std::size_t TextPlaces::offset(const EditorPosition& position) const {
  std::size_t at = lines_.position({std::max(0, position.line) + 1, 1});
  for (int units = 0; units < position.character && at < text_.size();) {
    if (text_[at] == '\n' || text_.substr(at).starts_with("\r\n")) break;
    const std::size_t bytes = next(text_, at);
    units += utf16_units(bytes);
    if (units <= position.character) at += bytes;  // between the halves of a character is before it
  }
  return at;
}

EditorPosition TextPlaces::position(std::size_t offset) {
  offset = std::min(offset, text_.size());
  const int line = lines_.mark(offset).line;
  EditorPosition position{line - 1, 0};
  for (std::size_t at = lines_.position({line, 1}); at < offset;) {
    const std::size_t bytes = next(text_, at);
    position.character += utf16_units(bytes);
    at += bytes;
  }
  return position;
}

}  // namespace stepwire::language
