#pragma once

#include <string>

namespace stepwire::studio {

/// Returns `text` with the line ends of `file`. A line that exists in the file keeps its own end, "\n" or
/// "\r\n"; a new line gets the most frequent end of the file. Lines of `text` end in "\n".
std::string with_line_ends_of(const std::string& file, const std::string& text);

}  // namespace stepwire::studio
