#include "engine/base/yaml/text_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire::yaml {
namespace {

bool is_plain(unsigned char c) {
  return (c >= 0x20 && c < 0x7f) || c == '\n' || c == '\t';
}

Mark mark_at(std::string_view text, std::size_t position) {
  Mark mark{1, 1};
  for (std::size_t i = 0; i < position; i += std::max<std::size_t>(1, text::utf8_length(text.substr(i)))) {
    ++mark.column;
    if (text[i] == '\n') mark = {mark.line + 1, 1};
  }
  return mark;
}

std::string message_for(unsigned char c) {
  if (c == '\r')
    return "a carriage return without a line feed; save the file with line ends of Unix or Windows";
  if (c == 0) return "a NUL byte; this is no text file (or it is UTF-16: save it as UTF-8)";
  if (c == 0xfe || c == 0xff) return fmt::format("the byte 0x{:02x} is no UTF-8; save the file as UTF-8", c);
  if (c < 0x80) return fmt::format("the control character 0x{:02x} cannot stand in a YAML file", c);
  return fmt::format("the byte 0x{:02x} is no UTF-8 here; save the file as UTF-8", c);
}

}  // namespace

std::optional<TextFault> check_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    // A lone carriage return is refused: the YAML library does not treat it as a line end, so all text would
    // be one line.
    const bool line_end = c == '\r' && text.substr(i + 1).starts_with('\n');
    const std::size_t length = is_plain(c) || line_end ? 1 : c < 0x80 ? 0 : text::utf8_length(text.substr(i));
    if (length == 0) return TextFault{mark_at(text, i), message_for(c)};
    i += length;
  }
  return std::nullopt;
}

}  // namespace stepwire::yaml
