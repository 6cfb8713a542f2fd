#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

/// A piece of a text that is replaced by another.
struct Splice {
  TextRange range;
  std::string text;
};

/// A change of a text that cannot be made, or would change more than what it is made for; the reason is a
/// sentence.
class EditRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The text with all splices in it, which stand in any order. Throws EditRefused where two of them overlap.
std::string spliced(std::string_view text, std::vector<Splice> splices);

/// The same for splices of names and values in a diagram file. The text is read before and after: where
/// anything but the keys and scalars in which the splices lie would be different, or it could not be read any
/// more, it throws EditRefused.
std::string spliced_values(std::string_view text, const std::vector<Splice>& splices);

}  // namespace stepwire::language
