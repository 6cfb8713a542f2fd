#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/app/studio/text_changes.hpp"

namespace stepwire::studio {

/// Result of a merge into an edited text.
struct TextMerge {
  std::vector<TextChange> changes;  ///< of the edited text
  bool is_clean = true;             ///< false for conflicts, which leave the lines of `theirs` as comments
};

/// Merges two texts with a common ancestor. Lines that only one of them changed are taken from that one.
/// Where both changed the same lines, those of `ours` stay, and those of `theirs` follow as YAML comments.
/// The text thus remains valid, and no line is lost.
TextMerge merge(std::string_view base, std::string_view ours, std::string_view theirs);
/// Merges two texts without a known ancestor: their common lines serve as the base. The result is never
/// clean.
TextMerge merge(std::string_view ours, std::string_view theirs);

}  // namespace stepwire::studio
