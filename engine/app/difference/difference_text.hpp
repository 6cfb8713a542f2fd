#pragma once

#include <string>

#include "engine/app/difference/difference.hpp"

namespace stepwire::difference {

/// Returns the differences for readers: files, sections, and a line for each change with its sign. The text
/// is empty without differences.
std::string text_of(const Difference& difference);

/// Returns a change in one line: "~ spring.gain: 1 N/m -> 2 N/m (2 times)".
std::string line_of(const Change& change);

/// Returns the facts of a file, one in a line, in the order of their names. Files with one meaning have one
/// text.
std::string facts_text(const Fact& root);

}  // namespace stepwire::difference
