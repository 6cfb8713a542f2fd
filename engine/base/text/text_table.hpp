#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::text {

/// A table for readers. Columns of numbers are aligned right, others left.
struct TextTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< each row is as long as `columns`
  std::vector<std::string> notes;              ///< below the table, one paragraph each
};

/// Returns the number of letters of a UTF-8 text.
std::size_t letters(const std::string& text);

/// Layout of a column.
struct ColumnLook {
  std::size_t width = 0;  ///< letters of the widest cell
  bool right = true;
};

std::vector<ColumnLook> columns_of(const TextTable& table);

/// Wraps the notes into lines of at most `max_letters` letters; a longer word has a line of its own.
std::vector<std::string> note_lines(const TextTable& table, std::size_t max_letters);

/// Renders the table for a monospaced font, with its notes wrapped below it.
std::string text(const TextTable& table);

}  // namespace stepwire::text
