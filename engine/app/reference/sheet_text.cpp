#include "engine/app/reference/sheet_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace stepwire::reference {

namespace {

constexpr std::size_t narrowest_text = 40;

using Cells = std::vector<std::string>;

std::vector<std::size_t> widths_of(const ReferenceTable& table) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i + 1 < table.header.size(); ++i) {
    std::size_t widest = width(table.header[i]);
    for (const Cells& row : table.rows) widest = std::max(widest, width(row[i]));
    widths.push_back(widest);
  }
  return widths;
}

/// Formats a row. The explanation is in the last column, or on lines of its own if `below`.
std::string line_of(const Cells& cells, const std::vector<std::size_t>& widths, bool below) {
  std::string line = "  ";
  for (std::size_t i = 0; i < widths.size(); ++i) line += padded(cells[i], widths[i]) + "  ";
  if (!below) return line + wrapped(cells.back(), width(line)) + "\n";
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n      " + wrapped(cells.back(), 6) + "\n";
}

std::string row_text(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

}  // namespace

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t to) {
  return text + std::string(to > width(text) ? to - width(text) : 0, ' ');
}

std::string wrapped(const std::string& text, std::size_t indent) {
  const std::size_t room = std::max(narrowest_text, page_width > indent ? page_width - indent : 0);
  std::istringstream words(text);
  std::string result, word;
  std::size_t used = 0;
  while (words >> word) {
    if (used > 0 && used + 1 + width(word) > room) {
      result += "\n" + std::string(indent, ' ');
      used = 0;
    }
    result += (used > 0 ? " " : "") + word;
    used += (used > 0 ? 1 : 0) + width(word);
  }
  return result;
}

std::string indented(const std::string& text) {
  std::string result = "  ";
  for (char c : text) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return result;
}

std::string shortened(const std::string& text, std::size_t to) {
  if (width(text) <= to) return text;
  const std::size_t end = text.rfind(' ', to - 4);
  return text.substr(0, end) + " ...";
}

std::string table_text(const ReferenceTable& table) {
  const std::vector<std::size_t> widths = widths_of(table);
  std::size_t used = 2;
  for (std::size_t column : widths) used += column + 2;
  const bool below = used + narrowest_text > page_width;
  std::string text = "\n" + table.title + "\n" + line_of(table.header, widths, below);
  for (const Cells& row : table.rows) text += line_of(row, widths, below);
  return text;
}

// Escapes '|', which would end a cell but is also the absolute value in formulas, and '*', which would begin
// emphasis.
std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '|' || c == '*') result += '\\';
    result += c;
  }
  return result;
}

std::string table_markdown(const ReferenceTable& table, const std::string& marks) {
  std::string text = "\n" + marks + "# " + table.title + "\n\n" + row_text(table.header);
  text += row_text(std::vector<std::string>(table.header.size(), "---"));
  for (std::vector<std::string> row : table.rows) {
    for (std::string& cell : row) cell = escaped(cell);
    row.front() = "`" + row.front() + "`";
    text += row_text(row);
  }
  return text;
}

}  // namespace stepwire::reference
