#include "engine/base/text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/text/characters.hpp"

namespace stepwire::text {
namespace {

/// True for a number, or for an empty cell or dash in the place of one.
bool is_number(const std::string& cell) {
  return cell.empty() || cell == "–" || cell.find_first_of("0123456789") <= cell.find_first_not_of("-+<. ");
}

std::string padded(const std::string& cell, const ColumnLook& column) {
  const std::string blanks(column.width - letters(cell), ' ');
  return column.right ? blanks + cell : cell + blanks;
}

std::string line(const std::vector<std::string>& cells, const std::vector<ColumnLook>& columns) {
  std::string result;
  for (std::size_t i = 0; i < cells.size(); ++i) result += (i > 0 ? "  " : "") + padded(cells[i], columns[i]);
  return result.substr(0, result.find_last_not_of(' ') + 1) + "\n";
}

/// Wraps a paragraph into lines of at most `most` letters.
std::vector<std::string> wrapped(const std::string& paragraph, std::size_t most) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at <= paragraph.size();) {
    const std::size_t end = std::min(paragraph.find(' ', at), paragraph.size());
    const std::string word = paragraph.substr(at, end - at);
    if (!lines.back().empty() && letters(lines.back()) + 1 + letters(word) > most) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80U; }));
}

std::vector<ColumnLook> columns_of(const TextTable& table) {
  std::vector<ColumnLook> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    ColumnLook column{letters(table.columns[i]), i > 0};
    for (const auto& row : table.rows) {
      column.width = std::max(column.width, letters(row[i]));
      column.right = column.right && is_number(row[i]);
    }
    columns.push_back(column);
  }
  return columns;
}

std::vector<std::string> note_lines(const TextTable& table, std::size_t most) {
  std::vector<std::string> lines;
  for (const std::string& note : table.notes)
    for (std::string& text : wrapped(note, most)) lines.push_back(std::move(text));
  return lines;
}

std::string text(const TextTable& given) {
  TextTable table = given;
  for (auto& row : table.rows)
    for (std::string& cell : row) cell = visible(cell);
  const auto columns = columns_of(table);
  std::size_t width = 0;
  for (const ColumnLook& column : columns) width += column.width + (width > 0 ? 2 : 0);
  std::string result = table.title + "\n" + line(table.columns, columns);
  result += std::string(width, '-') + "\n";
  for (const auto& row : table.rows) result += line(row, columns);
  for (const std::string& note : note_lines(table, std::max<std::size_t>(width, 80))) result += note + "\n";
  return result;
}

}  // namespace stepwire::text
