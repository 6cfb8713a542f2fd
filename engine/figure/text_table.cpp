#include "engine/figure/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/characters.hpp"
#include "engine/figure/svg.hpp"

namespace stepwire {
namespace {

constexpr double letter = 7.1, note_letter = 6.0, row_height = 23.0, gap = 26.0, margin = 18.0;  // [pixels]

/// Letters of a UTF-8 text.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80U; }));
}

/// A number, or what stands where there is none.
bool is_number(const std::string& cell) {
  return cell.empty() || cell == "–" || cell.find_first_of("0123456789") <= cell.find_first_not_of("-+<. ");
}

struct ColumnLook {
  std::size_t width = 0;  ///< letters of its widest cell
  bool right = true;
};

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

std::string padded(const std::string& cell, const ColumnLook& column) {
  const std::string blanks(column.width - letters(cell), ' ');
  return column.right ? blanks + cell : cell + blanks;
}

std::string line(const std::vector<std::string>& cells, const std::vector<ColumnLook>& columns) {
  std::string result;
  for (std::size_t i = 0; i < cells.size(); ++i) result += (i > 0 ? "  " : "") + padded(cells[i], columns[i]);
  return result.substr(0, result.find_last_not_of(' ') + 1) + "\n";
}

/// A paragraph in lines of so many letters.
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

std::vector<std::string> note_lines(const TextTable& table, std::size_t most) {
  std::vector<std::string> lines;
  for (const std::string& note : table.notes)
    for (std::string& text : wrapped(note, most)) lines.push_back(std::move(text));
  return lines;
}

/// The SVG of a table while it grows downwards.
class TableDrawing {
 public:
  explicit TableDrawing(const TextTable& table) : table_(table), columns_(columns_of(table)) {
    double x = margin;
    for (const ColumnLook& column : columns_) {
      left_.push_back(x);
      x += letter * static_cast<double>(column.width) + gap;
    }
    width_ =
        std::max({x - gap + margin, 2.0 * margin + 7.8 * static_cast<double>(letters(table.title)), 420.0});
  }

  std::string svg() {
    y_ += 28.0;
    text(0.5 * width_, "middle", 15.0, "#111111", table_.title);
    y_ += 12.0;
    rule(1.4);
    row(table_.columns, "#111111");
    rule(0.8);
    for (const auto& cells : table_.rows) row(cells, "#333333");
    rule(1.4);
    y_ += 4.0;
    for (const std::string& note :
         note_lines(table_, static_cast<std::size_t>((width_ - 2.0 * margin) / note_letter))) {
      y_ += 16.0;
      text(margin, "start", 11.5, "#555555", note);
    }
    y_ += margin;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 "
        "{0:.0f} "
        "{1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>{2}</title>{4}\n<rect "
        "width=\"100%\" "
        "height=\"100%\" fill=\"#ffffff\"/>\n{3}</svg>\n",
        width_, y_, markup_escaped(table_.title), body_, dark_style);
  }

 private:
  void text(double x, const char* anchor, double size, const char* color, const std::string& words) {
    body_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n", x, y_,
        anchor, size, color, markup_escaped(words));
  }

  void rule(double thickness) {
    body_ += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#8a8a8a\" stroke-width=\"{}\"/>\n",
                         margin, y_, width_ - margin, thickness);
  }

  void row(const std::vector<std::string>& cells, const char* color) {
    y_ += row_height - 6.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double right = left_[i] + letter * static_cast<double>(columns_[i].width);
      text(columns_[i].right ? right : left_[i], columns_[i].right ? "end" : "start", 13.0, color, cells[i]);
    }
    y_ += 6.0;
  }

  const TextTable& table_;
  std::vector<ColumnLook> columns_;
  std::vector<double> left_;
  double width_ = 0.0, y_ = 0.0;
  std::string body_;
};

}  // namespace

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

std::string draw(const TextTable& table) {
  return TableDrawing(table).svg();
}

}  // namespace stepwire
