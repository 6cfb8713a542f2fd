#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stepwire::text {

/// Returns the length in bytes of the UTF-8 character at the start of `text`; 0 for invalid UTF-8.
std::size_t utf8_length(std::string_view text);

/// Returns a text that is safe to show in one line of a terminal, a message or a comment. Characters that
/// move the cursor, break the line or turn the direction of writing are escaped: \n, \x1b, \u202e. So are
/// noncharacters; invalid UTF-8 becomes \xff. Other texts are returned unchanged.
std::string visible(std::string_view text);

/// Does the same for a text of several lines: line ends and tabs stay.
std::string visible_lines(std::string_view text);

/// Returns a text for pictures and pages: characters that visible() would escape become blanks, since XML
/// refuses many of them. Line ends and tabs stay.
std::string printable(std::string_view text);

/// Escapes the control characters of a JSON text as \u0085; they occur only within its strings.
std::string json_escaped(std::string_view text);

/// Returns a text as one word of a POSIX shell, quoted if necessary.
std::string shell_word(std::string_view text);

void replace_all(std::string& text, const std::string& from, const std::string& to);

}  // namespace stepwire::text
