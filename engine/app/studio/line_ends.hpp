#pragma once

#include <string>

namespace stepwire::studio {

/// The text with the ends of lines that a file has: each line that stood in the file keeps its own, "\n" or
/// "\r\n", and new ones get the end that most lines of the file have. Ends of lines in `text` are "\n".
std::string with_line_ends_of(const std::string& file, const std::string& text);

}  // namespace stepwire::studio
