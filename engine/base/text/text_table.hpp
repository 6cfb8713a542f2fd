#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::text {

/// A table for readers. Columns of numbers are set to the right, others to the left.
struct TextTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
  std::vector<std::string> notes;              ///< below it, one paragraph each
};

/// Letters of a UTF-8 text.
std::size_t letters(const std::string& text);

/// How a column is set.
struct ColumnLook {
  std::size_t width = 0;  ///< letters of its widest cell
  bool right = true;
};

std::vector<ColumnLook> columns_of(const TextTable& table);

/// The notes in lines of at most so many letters; a longer word has a line of its own.
std::vector<std::string> note_lines(const TextTable& table, std::size_t max_letters);

/// The table in letters of one width, its notes wrapped below it.
std::string text(const TextTable& table);

}  // namespace stepwire::text
