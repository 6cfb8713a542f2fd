#pragma once

#include <string>

#include "engine/app/difference/difference.hpp"

namespace stepwire::difference {

/// Returns the differences for readers: files, sections, and a line for each change with its sign. The text
/// is empty without differences.
std::string text_of(const Difference& difference);

/// Returns the facts of a file, one in a line, in the order of their names. Files with one meaning have one
/// text.
std::string facts_text(const Fact& root);

}  // namespace stepwire::difference
