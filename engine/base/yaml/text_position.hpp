#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

/// Turns positions in a text, in bytes from its start, into the marks that a person sees: characters, counted
/// from 1.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);

  /// Of a position, or of the end where it lies behind that. Positions in order cost the least.
  Mark mark(std::size_t position);
  /// The position of a mark; the end of its line, or of the text, where it lies behind that.
  std::size_t position(const Mark& mark) const;
  std::string_view text() const { return text_; }
  std::string_view text_at(std::size_t position) const;
  /// Column of the first tab among the blanks that start the line.
  std::optional<int> tab_in_indentation(std::size_t position);

 private:
  std::size_t line_of(std::size_t position);
  int characters(std::size_t from, std::size_t to);

  std::string_view text_;
  std::vector<std::size_t> lines_;  ///< where each begins
  std::size_t last_line_ = 0;
  std::size_t counted_from_ = 0, counted_to_ = 0;
  int count_ = 0;
};

/// Whether a text begins with a null that somebody wrote, and not with whatever follows a value left out.
bool starts_with_null(std::string_view text);

/// Whether a text in quotes (perhaps after its anchor) goes on to the end of the file.
bool lacks_closing_quote(std::string_view text);

}  // namespace stepwire::yaml
