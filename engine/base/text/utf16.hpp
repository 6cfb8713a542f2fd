#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace stepwire::text {

/// Appends a Unicode code point as UTF-8.
void append_utf8(std::string& text, std::uint32_t code);

/// Converts UTF-16 to UTF-8. An unpaired surrogate becomes the replacement character.
std::string utf8_of_utf16(std::span<const std::uint16_t> units);

}  // namespace stepwire::text
