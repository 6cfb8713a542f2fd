#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

/// Converts byte positions in a text to marks (line and character, counted from 1) and back.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);

  /// Returns the mark of a position; the end of the text for a position beyond it. Ascending positions are
  /// fastest.
  Mark mark(std::size_t position);
  /// Returns the position of a mark; the end of its line or of the text for a mark beyond it.
  std::size_t position(const Mark& mark) const;
  std::string_view text() const { return text_; }
  std::string_view text_at(std::size_t position) const;
  /// Returns the column of the first tab in the indentation of the line; std::nullopt without one.
  std::optional<int> tab_in_indentation(std::size_t position);

 private:
  std::size_t line_of(std::size_t position);
  int characters(std::size_t from, std::size_t to);

  std::string_view text_;
  std::vector<std::size_t> lines_;  ///< start of each line
  std::size_t last_line_ = 0;
  std::size_t counted_from_ = 0, counted_to_ = 0;
  int count_ = 0;
};

/// True where a text begins with an explicit null; false for the text that follows an omitted value.
bool starts_with_null(std::string_view text);

/// True where a quoted text (possibly after its anchor) extends to the end of the file.
bool lacks_closing_quote(std::string_view text);

}  // namespace stepwire::yaml
