#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stepwire::text {

/// Length in bytes of the UTF-8 character at the start of `text`; 0 if it is none.
std::size_t utf8_length(std::string_view text);

/// A text as one line of a terminal, a message or a comment shows it: what moves the cursor, breaks the line,
/// turns the direction of writing or is no character at all is written out as \n, \x1b, \u202e; bytes that
/// are no UTF-8 as \xff. A text without any of these is itself.
std::string visible(std::string_view text);

/// The same for a text of several lines: ends of lines and tabs stay.
std::string visible_lines(std::string_view text);

/// A text as a picture or a page shows it: what visible() would write out is a blank there, since XML refuses
/// much of it. Ends of lines and tabs stay.
std::string printable(std::string_view text);

/// The control characters of a text in JSON as its escapes, \u0085; they can only stand in its strings.
std::string json_escaped(std::string_view text);

/// A text as one word of a POSIX shell: in quotes where it has to be.
std::string shell_word(std::string_view text);

void replace_all(std::string& text, const std::string& from, const std::string& to);

}  // namespace stepwire::text
