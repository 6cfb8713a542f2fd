#pragma once

#include <cstddef>
#include <string_view>

namespace stepwire::yaml {

// Start and end of YAML values in their text, as byte positions. The text must already have been parsed
// successfully.

/// Returns the start of the value after an optional anchor (&name) or tag (!) at `at`; `at` itself if no
/// value follows.
std::size_t value_start(std::string_view text, std::size_t at);

/// Returns the end of the scalar that begins at `start` and was parsed as `value`: after its closing quote,
/// or after its last non-blank character.
std::size_t scalar_end(std::string_view text, std::size_t start, std::string_view value);

/// Returns the position after the bracket that closes a list or map, whose last value ends at `last`.
std::size_t bracket_end(std::string_view text, std::size_t last);

/// Returns the position after a word such as *name or null.
std::size_t word_end(std::string_view text, std::size_t start);

}  // namespace stepwire::yaml
