#include "engine/base/yaml/text_position.hpp"

#include <algorithm>

namespace stepwire::yaml {

Mark LineIndex::mark(const TextPosition& spot) {
  const std::size_t position = std::min(spot.position, text_.size());
  return {spot.line + 1, characters(line_start(spot), position) + 1};
}

std::string_view LineIndex::text_at(const TextPosition& spot) const {
  return text_.substr(std::min(spot.position, text_.size()));
}

std::optional<int> LineIndex::tab_in_indentation(const TextPosition& spot) const {
  const std::string_view line = text_.substr(line_start(spot));
  const std::size_t first = line.find_first_not_of(' ');
  if (first == std::string_view::npos || line[first] != '\t') return std::nullopt;
  return static_cast<int>(first) + 1;
}

std::size_t LineIndex::line_start(const TextPosition& spot) const {
  const std::size_t position = std::min(spot.position, text_.size());
  return position - std::min(static_cast<std::size_t>(spot.column), position);
}

// Spots come mostly in order, so that a long line is counted once and not once per spot.
int LineIndex::characters(std::size_t from, std::size_t to) {
  if (from != counted_from_ || to < counted_to_) {
    counted_from_ = counted_to_ = from;
    count_ = 0;
  }
  for (; counted_to_ < to; ++counted_to_) count_ += (text_[counted_to_] & 0xc0) != 0x80;
  return count_;
}

bool starts_with_null(std::string_view text) {
  for (const std::string_view null : {"~", "null", "Null", "NULL"}) {
    if (!text.starts_with(null)) continue;
    const std::string_view behind = text.substr(null.size());
    return behind.empty() || std::string_view(" \t\r\n,]}:").find(behind.front()) != std::string_view::npos;
  }
  return false;
}

bool lacks_closing_quote(std::string_view text) {
  if (text.starts_with('&')) text.remove_prefix(std::min(text.find_first_of(" \n"), text.size()));
  text.remove_prefix(std::min(text.find_first_not_of(" \n"), text.size()));
  if (text.empty() || (text[0] != '"' && text[0] != '\'')) return false;
  for (std::size_t i = 1; i < text.size(); ++i) {
    const bool doubled = text[0] == '\'' && text.substr(i, 2) == "''";
    const bool escaped = text[0] == '"' && text[i] == '\\';
    if (doubled || escaped) {
      ++i;
    } else if (text[i] == text[0]) {
      return false;
    }
  }
  return true;
}

}  // namespace stepwire::yaml
