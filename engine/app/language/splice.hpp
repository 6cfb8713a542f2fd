#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

/// Replacement of a range of a text.
struct Splice {
  TextRange range;
  std::string text;
};

/// Refusal of a text change that is impossible or would affect other parts of the file. The reason is a
/// sentence.
class EditRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Applies splices in any order. Throws EditRefused if two of them overlap.
std::string spliced(std::string_view text, std::vector<Splice> splices);

/// Applies splices of names and values to a diagram file, and parses the text before and after. Throws
/// EditRefused if other keys or scalars would change, or if the result is invalid.
std::string spliced_values(std::string_view text, const std::vector<Splice>& splices);

}  // namespace stepwire::language
