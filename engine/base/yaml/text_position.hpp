#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

/// Where a reader stands: bytes from the start of the text, lines and bytes in the line, all counted from
/// zero.
struct TextPosition {
  std::size_t position = 0;
  int line = 0, column = 0;
};

/// Turns the spots of a text into the marks that a person sees: characters, counted from 1.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text) : text_(text) {}

  Mark mark(const TextPosition& spot);
  std::string_view text_at(const TextPosition& spot) const;
  /// Column of the first tab among the blanks that start the line.
  std::optional<int> tab_in_indentation(const TextPosition& spot) const;

 private:
  std::size_t line_start(const TextPosition& spot) const;
  int characters(std::size_t from, std::size_t to);

  std::string_view text_;
  std::size_t counted_from_ = 0, counted_to_ = 0;
  int count_ = 0;
};

/// Whether a text begins with a null that somebody wrote, and not with whatever follows a value left out.
bool starts_with_null(std::string_view text);

/// Whether a text in quotes (perhaps after its anchor) goes on to the end of the file.
bool lacks_closing_quote(std::string_view text);

}  // namespace stepwire::yaml
