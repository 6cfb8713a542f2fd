#pragma once

#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::language {

/// Text of a value at a place, and its parsed node.
struct WrittenValue {
  std::string text;
  yaml::Node node;
};

/// Returns the notation of a value at a place: unchanged, such as "8 kg" or "[1, 2]", or quoted if it would
/// otherwise be parsed differently.
/// Examples of the latter are "max(a, b)" within brackets (`flow`) and a text with '#'. `quote` is the quote
/// of the old value, which is kept; 0 if it had none. Throws EditRefused for text that is no single-line
/// value.
WrittenValue written_value(const std::string& text, bool flow, char quote = 0);

}  // namespace stepwire::language
