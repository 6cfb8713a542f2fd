#include "engine/base/yaml/text_extent.hpp"

#include <algorithm>

namespace stepwire::yaml {
namespace {

constexpr std::string_view blanks = " \t\r\n";

bool is_blank(char c) {
  return blanks.find(c) != std::string_view::npos;
}

bool is_bracket(char c) {
  return c == ']' || c == '}';
}

std::size_t line_end(std::string_view text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

std::size_t quoted_end(std::string_view text, std::size_t start) {
  const char quote = text[start];
  for (std::size_t at = start + 1; at < text.size(); ++at) {
    const bool doubled = quote == '\'' && text.substr(at, 2) == "''";
    const bool escaped = quote == '"' && text[at] == '\\';
    if (doubled || escaped)
      ++at;
    else if (text[at] == quote)
      return at + 1;
  }
  return text.size();
}

/// Returns the end of `value` in the text, which has the same characters but possibly other blanks.
std::size_t matched_end(std::string_view text, std::size_t start, std::size_t at, std::string_view value) {
  std::size_t end = start;
  for (const char c : value) {
    if (is_blank(c)) continue;
    while (at < text.size() && is_blank(text[at])) ++at;
    if (at == text.size() || text[at] != c) break;
    end = ++at;
  }
  return end;
}

/// Skips blanks, comments and the characters in `further`.
std::size_t skipped(std::string_view text, std::size_t at, std::string_view further) {
  while (at < text.size()) {
    if (text[at] == '#')
      at = line_end(text, at);
    else if (is_blank(text[at]) || further.find(text[at]) != std::string_view::npos)
      ++at;
    else
      break;
  }
  return at;
}

}  // namespace

std::size_t value_start(std::string_view text, std::size_t at) {
  std::size_t start = at;
  while (start < text.size() && (text[start] == '&' || text[start] == '!'))
    start = skipped(text, word_end(text, start), "");
  const bool nothing = start >= text.size() || is_bracket(text[start]) || text[start] == ',';
  return nothing ? std::min(at, text.size()) : start;
}

std::size_t scalar_end(std::string_view text, std::size_t start, std::string_view value) {
  if (start >= text.size()) return text.size();
  const char first = text[start];
  if (first == '"' || first == '\'') return quoted_end(text, start);
  if (first != '|' && first != '>') return matched_end(text, start, start, value);
  const std::size_t head = word_end(text, start);
  return matched_end(text, head, line_end(text, head), value);
}

std::size_t bracket_end(std::string_view text, std::size_t last) {
  std::size_t at = skipped(text, last, ",:?");
  while (at < text.size() && (text[at] == '&' || text[at] == '!'))  // of an omitted value
    at = skipped(text, word_end(text, at), ",:?");
  return at < text.size() && is_bracket(text[at]) ? at + 1 : last;
}

std::size_t word_end(std::string_view text, std::size_t start) {
  const std::size_t end = text.find_first_of(" \t\r\n,[]{}", start);
  return std::min(end, text.size());
}

}  // namespace stepwire::yaml
