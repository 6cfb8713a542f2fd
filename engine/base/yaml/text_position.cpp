#include "engine/base/yaml/text_position.hpp"

#include <algorithm>

#include "engine/base/text/characters.hpp"

namespace stepwire::yaml {

LineIndex::LineIndex(std::string_view text) : text_(text), lines_{0} {
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    lines_.push_back(at + 1);
}

Mark LineIndex::mark(std::size_t position) {
  position = std::min(position, text_.size());
  const std::size_t line = line_of(position);
  return {static_cast<int>(line) + 1, characters(lines_[line], position) + 1};
}

std::size_t LineIndex::position(const Mark& mark) const {
  const auto line = static_cast<std::size_t>(std::max(1, mark.line)) - 1;
  if (line >= lines_.size()) return text_.size();
  std::size_t at = lines_[line];
  const std::size_t end = std::min(text_.find('\n', at), text_.size());
  for (int column = 1; column < mark.column && at < end; ++column)
    at += std::max<std::size_t>(1, text::utf8_length(text_.substr(at)));
  return std::min(at, end);
}

std::string_view LineIndex::text_at(std::size_t position) const {
  return text_.substr(std::min(position, text_.size()));
}

std::optional<int> LineIndex::tab_in_indentation(std::size_t position) {
  const std::string_view line = text_.substr(lines_[line_of(position)]);
  const std::size_t first = line.find_first_not_of(' ');
  if (first == std::string_view::npos || line[first] != '\t') return std::nullopt;
  return static_cast<int>(first) + 1;
}

// Returns the line of a position. It tries the previous line first, since positions are mostly in order.
std::size_t LineIndex::line_of(std::size_t position) {
  const bool same = lines_[last_line_] <= position &&
                    (last_line_ + 1 == lines_.size() || position < lines_[last_line_ + 1]);
  if (!same) {
    const auto behind = std::upper_bound(lines_.begin(), lines_.end(), position);
    last_line_ = static_cast<std::size_t>(behind - lines_.begin()) - 1;
  }
  return last_line_;
}

// Counts characters. Positions are mostly in order, so the previous count continues instead of starting
// again.
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
