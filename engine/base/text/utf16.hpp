#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace stepwire::text {

/// Adds a character by its number in Unicode.
void append_utf8(std::string& text, std::uint32_t code);

/// A text in UTF-16 as UTF-8. A surrogate without its other half becomes the replacement character.
std::string utf8_of_utf16(std::span<const std::uint16_t> units);

}  // namespace stepwire::text
