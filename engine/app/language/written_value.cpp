#include "engine/app/language/written_value.hpp"

#include <fmt/format.h>

#include <optional>

#include "engine/app/language/splice.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::language {

namespace {

std::string in_quotes(const std::string& text, char quote) {
  std::string result(1, quote);
  for (const char c : text) {
    if (c == quote || (quote == '"' && c == '\\')) result += quote == '"' ? '\\' : quote;
    result += c;
  }
  return result + quote;
}

/// Parses a text as a value of a map, with or without brackets; std::nullopt if it is none.
std::optional<yaml::Node> value_of(const std::string& text, bool flow) {
  try {
    const yaml::Document read = yaml::parse_document(flow ? "{v: " + text + "}" : "v: " + text, "");
    if (!read.root.is_map() || read.root.entries.size() != 1 || read.root.entries[0].key != "v")
      return std::nullopt;
    return read.root.entries[0].value;
  } catch (const yaml::Error&) {
    return std::nullopt;
  }
}

/// True if the value contains the whole text, that is, no part of it is an anchor, a tag or a comment.
bool is_whole(const yaml::Node& value, const std::string& text) {
  if (value.is_scalar()) return value.text == text || text[0] == '"' || text[0] == '\'';
  return (value.is_list() || value.is_map()) && text.find('#') == std::string::npos && text[0] != '&' &&
         text[0] != '!';
}

}  // namespace

WrittenValue written_value(const std::string& text, bool flow, char quote) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  if (first == std::string::npos) throw EditRefused("a value is missing");
  if (text.find_first_of("\r\n") != std::string::npos) throw EditRefused("a value stands in one line here");
  const std::string value = text.substr(first, last - first + 1);
  const auto plain = value_of(value, flow);
  const bool keeps_quotes = quote != 0 && plain && plain->is_scalar() && !plain->quoted;
  if (plain && is_whole(*plain, value) && !keeps_quotes) return {value, *plain};
  const std::string quoted = in_quotes(value, quote ? quote : '"');
  if (const auto read = value_of(quoted, flow); read && read->text == value) return {quoted, *read};
  throw EditRefused(fmt::format("'{}' is no value", text::visible(value)));
}

}  // namespace stepwire::language
