#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "engine/table/file.hpp"

namespace stepwire {
namespace {

void append_title(std::string& text, const Column& column) {
  const std::string title =
      column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
  if (title.find_first_of(",;\t\"\n\r") == std::string::npos) {
    text += title;
    return;
  }
  text += '"';
  for (const char c : title) text += c == '"' ? "\"\"" : std::string(1, c);
  text += '"';
}

void append_number(std::string& text, double value) {
  if (std::isnan(value)) {
    text += "nan";  // without the sign that a nan may have
    return;
  }
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr);
}

void check_lengths(const Table& table) {
  for (const Column& column : table.columns) {
    if (column.values.size() == table.rows()) continue;
    throw TableError(fmt::format("column '{}' has {} rows, '{}' has {}", column.name, column.values.size(),
                                 table.columns.front().name, table.rows()));
  }
}

}  // namespace

std::string csv_text(const Table& table) {
  check_lengths(table);
  std::string text;
  text.reserve(table.rows() * table.columns.size() * 12);
  for (const Column& column : table.columns) {
    if (&column != &table.columns.front()) text += ',';
    append_title(text, column);
  }
  text += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const Column& column : table.columns) {
      if (&column != &table.columns.front()) text += ',';
      append_number(text, column.values[row]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace stepwire
