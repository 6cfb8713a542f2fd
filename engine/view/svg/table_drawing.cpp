#include "engine/view/svg/table_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/view/svg/svg.hpp"

namespace stepwire::svg {
namespace {

constexpr double letter = 7.1, note_letter = 6.0, row_height = 23.0, gap = 26.0, margin = 18.0;  // [pixels]

/// SVG of a table that grows downwards.
class TableDrawing {
 public:
  explicit TableDrawing(const text::TextTable& table) : table_(table), columns_(text::columns_of(table)) {
    double x = margin;
    for (const text::ColumnLook& column : columns_) {
      left_.push_back(x);
      x += letter * static_cast<double>(column.width) + gap;
    }
    width_ = std::max(
        {x - gap + margin, 2.0 * margin + 7.8 * static_cast<double>(text::letters(table.title)), 420.0});
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
         text::note_lines(table_, static_cast<std::size_t>((width_ - 2.0 * margin) / note_letter))) {
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

  const text::TextTable& table_;
  std::vector<text::ColumnLook> columns_;
  std::vector<double> left_;
  double width_ = 0.0, y_ = 0.0;
  std::string body_;
};

}  // namespace

std::string draw(const text::TextTable& table) {
  return TableDrawing(table).svg();
}

}  // namespace stepwire::svg
