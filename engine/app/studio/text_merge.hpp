#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/app/studio/text_changes.hpp"

namespace stepwire::studio {

/// How the lines of another text come into an edited one.
struct TextMerge {
  std::vector<TextChange> changes;  ///< of the edited text
  bool is_clean = true;  ///< did the two change different lines? Else both are there, the other's as comments
};

/// Merges two texts that were made from the same one. Lines that only `theirs` has changed are taken from it,
/// and lines that only `ours` has changed stay. Where both changed the same lines, ours stay, and theirs
/// follow as comments of YAML, so that nothing is lost and the text can still be read.
TextMerge merge(std::string_view base, std::string_view ours, std::string_view theirs);
/// The same where it is not known what both were made from: that is what they have in common, and all lines
/// that both have in its place are such.
TextMerge merge(std::string_view ours, std::string_view theirs);

}  // namespace stepwire::studio
