#include "engine/base/text/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <utility>

namespace stepwire::text {
namespace {

constexpr char32_t no_character = 0xffffffff;

/// Ranges of characters that are invisible or change how their neighbours are shown. They are controls, line
/// separators, marks of direction, the byte order mark, annotations, tags and noncharacters.
constexpr std::array<std::pair<char32_t, char32_t>, 12> unseen{{{0x00, 0x1f},
                                                                {0x7f, 0x9f},
                                                                {0x61c, 0x61c},
                                                                {0x200e, 0x200f},
                                                                {0x2028, 0x202e},
                                                                {0x2066, 0x2069},
                                                                {0xfdd0, 0xfdef},
                                                                {0xfeff, 0xfeff},
                                                                {0xfff9, 0xfffb},
                                                                {0xfffe, 0xffff},
                                                                {0xe0000, 0xe007f},
                                                                {0x10ffff, no_character}}};

bool is_unseen(char32_t code) {
  const auto holds = [&](const auto& range) { return code >= range.first && code <= range.second; };
  return (code & 0xfffe) == 0xfffe || std::any_of(unseen.begin(), unseen.end(), holds);
}

/// Returns the code point of one UTF-8 character.
char32_t code_of(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0);
  char32_t code = byte(0) & (0x7fu >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6 | (byte(i) & 0x3fu);
  return code;
}

/// Replaces each unseen character of a text by other(code, bytes).
template <class Other>
std::string replaced(std::string_view text, const Other& other) {
  if (std::ranges::all_of(text, [](char c) { return ' ' <= c && c <= '~'; })) return std::string(text);
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(1, utf8_length(text));
    const std::string_view bytes = text.substr(0, length);
    const char32_t code = utf8_length(text) == 0 ? no_character : code_of(bytes);
    text.remove_prefix(length);
    if (is_unseen(code)) {
      result += other(code, bytes);
    } else {
      result += bytes;
    }
  }
  return result;
}

std::string written_out(char32_t code, std::string_view bytes) {
  if (code == no_character) return fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes.front()));
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  if (code < 0x80) return fmt::format("\\x{:02x}", static_cast<unsigned>(code));
  if (code < 0x10000) return fmt::format("\\u{:04x}", static_cast<unsigned>(code));
  return fmt::format("\\U{:08x}", static_cast<unsigned>(code));
}

bool parts_text(char32_t code) {
  return code == '\n' || code == '\t';
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const auto goes_on = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
  const unsigned first = byte(0), second = byte(1);
  if (text.empty()) return 0;
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return goes_on(1) ? 2 : 0;
  if (first >= 0xe0 && first <= 0xef) {
    const bool too_long = first == 0xe0 && second < 0xa0;
    const bool surrogate = first == 0xed && second > 0x9f;
    return goes_on(1) && goes_on(2) && !too_long && !surrogate ? 3 : 0;
  }
  if (first >= 0xf0 && first <= 0xf4) {
    const bool too_long = first == 0xf0 && second < 0x90;
    const bool too_large = first == 0xf4 && second > 0x8f;
    return goes_on(1) && goes_on(2) && goes_on(3) && !too_long && !too_large ? 4 : 0;
  }
  return 0;
}

std::string visible(std::string_view text) {
  return replaced(text, written_out);
}

std::string visible_lines(std::string_view text) {
  return replaced(text, [](char32_t code, std::string_view bytes) {
    return parts_text(code) ? std::string(bytes) : written_out(code, bytes);
  });
}

std::string printable(std::string_view text) {
  return replaced(text, [](char32_t code, std::string_view bytes) {
    return parts_text(code) ? std::string(bytes) : std::string(" ");
  });
}

std::string json_escaped(std::string_view text) {
  return replaced(text, [](char32_t code, std::string_view bytes) {
    if (code < 0x7f || code == no_character) return std::string(bytes);
    if (code < 0x10000) return fmt::format("\\u{:04x}", static_cast<unsigned>(code));
    const auto above = static_cast<unsigned>(code - 0x10000);
    return fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + (above >> 10), 0xdc00 + (above & 0x3ff));
  });
}

std::string shell_word(std::string_view text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=:@%+,-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace stepwire::text
