#include "engine/base/text/utf16.hpp"

#include <cstddef>

namespace stepwire::text {

void append_utf8(std::string& text, std::uint32_t code) {
  const auto tail = [&](unsigned shift) { text += static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6), tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | code >> 12), tail(6), tail(0);
  } else {
    text += static_cast<char>(0xF0 | (code >> 18 & 7)), tail(12), tail(6), tail(0);
  }
}

std::string utf8_of_utf16(std::span<const std::uint16_t> units) {
  constexpr std::uint32_t replacement = 0xFFFD;
  std::string text;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const std::uint32_t code = units[i], low = i + 1 < units.size() ? units[i + 1] : 0;
    if (code >> 10 == 0x36 && low >> 10 == 0x37) {
      append_utf8(text, 0x10000 + ((code & 0x3FF) << 10) + (low & 0x3FF));
      ++i;
    } else {
      append_utf8(text, code >> 11 == 0x1B ? replacement : code);
    }
  }
  return text;
}

}  // namespace stepwire::text
