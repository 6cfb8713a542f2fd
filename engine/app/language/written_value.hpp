#pragma once

#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::language {

/// How a value is written at a place, and what it is then.
struct WrittenValue {
  std::string text;
  yaml::Node node;
};

/// Writes a value as it is given, "8 kg", "[1, 2]", or in quotes where it would be something else without
/// them: "max(a, b)" inside of brackets (`flow`), a text with a comment. `quote` is the quote that the value
/// had before, which it keeps; 0 where it had none. Throws EditRefused for what is no value of one line.
WrittenValue written_value(const std::string& text, bool flow, char quote = 0);

}  // namespace stepwire::language
