#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stepwire::studio {

/// Replacement of a piece of a text. Places count UTF-16 units, as browsers do.
struct TextChange {
  std::size_t from = 0, to = 0;
  std::string text{};

  bool operator==(const TextChange&) const = default;
};

/// Returns the number of UTF-16 units of a UTF-8 text.
std::size_t utf16_length(std::string_view text);

/// Returns the text with all changes applied; their places refer to the original text. Throws Fault for
/// places outside the text or inside a character, and for changes that overlap.
std::string changed(std::string_view text, std::vector<TextChange> changes);

/// True for valid UTF-8.
bool is_utf8(std::string_view text);

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
