#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::table {

void append_csv_word(std::string& text, const std::string& given) {
  const std::string word = csv_cell(given);
  if (word.find_first_of(",;\t\"\n\r") == std::string::npos) {
    text += word;
    return;
  }
  text += '"';
  for (const char c : word) text += c == '"' ? "\"\"" : std::string(1, c);
  text += '"';
}

namespace {

void append_title(std::string& text, const Column& column) {
  append_csv_word(text, column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
}

using WordsOfColumns = std::vector<const std::vector<std::string>*>;

WordsOfColumns words_of(const Table& table, const ColumnWords& words) {
  WordsOfColumns result;
  for (const Column& column : table.columns) {
    const auto found = words.find(column.name);
    result.push_back(found == words.end() ? nullptr : &found->second);
  }
  return result;
}

void append_row(std::string& text, const Table& table, const WordsOfColumns& words, std::size_t row) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const double value = table.columns[i].values[row];
    if (i > 0) text += ',';
    if (words[i]) {
      append_csv_word(text, words[i]->at(static_cast<std::size_t>(value)));
    } else {
      append_csv_number(text, value);
    }
  }
  text += '\n';
}

void check_lengths(const Table& table) {
  for (const Column& column : table.columns) {
    if (column.values.size() == table.rows()) continue;
    throw TableError(fmt::format("column '{}' has {}, '{}' has {}", column.name,
                                 text::counted(column.values.size(), "row"), table.columns.front().name,
                                 table.rows()));
  }
}

}  // namespace

void append_csv_head(std::string& text, const std::vector<Column>& columns) {
  for (const Column& column : columns) {
    if (&column != &columns.front()) text += ',';
    append_title(text, column);
  }
  text += '\n';
}

void append_csv_number(std::string& text, double value) {
  if (std::isnan(value)) {
    text += "nan";  // without the sign that a NaN may have
    return;
  }
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr);
}

std::string csv_text(const Table& table, const ColumnWords& words) {
  check_lengths(table);
  std::string text;
  text.reserve(table.rows() * table.columns.size() * 12);
  append_csv_head(text, table.columns);
  const WordsOfColumns by_column = words_of(table, words);
  for (std::size_t row = 0; row < table.rows(); ++row) append_row(text, table, by_column, row);
  return text;
}

void write_csv(const std::string& path, const Table& table, const ColumnWords& words) {
  constexpr std::size_t many = 1'000'000, rows_of_piece = 10'000;
  if (table.rows() * table.columns.size() < many) return io::write_file(path, csv_text(table, words));
  check_lengths(table);
  const auto texts = words_of(table, words);
  io::AtomicFileWriter file(path);
  std::string piece;
  append_csv_head(piece, table.columns);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    append_row(piece, table, texts, row);
    if ((row + 1) % rows_of_piece != 0) continue;
    file.append(piece);
    piece.clear();
  }
  file.append(piece);
  file.finish();
}

}  // namespace stepwire::table
