#pragma once

#include <cstddef>
#include <string_view>

namespace stepwire::yaml {

// Where values of YAML begin and end in their text, as positions in bytes. The text has been read before: it
// is known what stands there, and that it is sound.

/// Where the value begins whose anchor (&name) or tag (!) may stand at `at`; `at` where nothing follows
/// those.
std::size_t value_start(std::string_view text, std::size_t at);

/// Just behind the last character of the scalar that begins at `start` and was read as `value`: behind its
/// closing quote, or behind its last character that is not blank.
std::size_t scalar_end(std::string_view text, std::size_t start, std::string_view value);

/// Just behind the bracket that closes a list or map, whose last value ends at `last`.
std::size_t bracket_end(std::string_view text, std::size_t last);

/// Just behind a word such as *name or null.
std::size_t word_end(std::string_view text, std::size_t start);

}  // namespace stepwire::yaml
