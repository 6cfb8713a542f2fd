#include "engine/view/render/pdf_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "engine/base/text/characters.hpp"

namespace stepwire::render {
namespace {

using Number = std::size_t;

/// Returns the integer after a word.
std::optional<Number> number_behind(std::string_view text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string_view::npos) return std::nullopt;
  const char *start = text.data() + at + word.size(), *const end = text.data() + text.size();
  Number number = 0;
  return std::from_chars(start, end, number).ec == std::errc{} ? std::optional(number) : std::nullopt;
}

/// Returns the dictionary of an object; an empty text if it is not found.
std::string_view object_of(std::string_view pdf, Number number) {
  const std::string head = fmt::format("\n{} 0 obj\n", number);
  const std::size_t at = pdf.find(head);
  if (at == std::string_view::npos) return {};
  return pdf.substr(at + head.size(), pdf.find("endobj", at) - at - head.size());
}

/// Returns the numbers of the objects in the list "/Kids [ 2 0 R 8 0 R ]".
std::vector<Number> kids_of(std::string_view pages) {
  std::vector<Number> kids;
  const std::size_t start = pages.find("/Kids [");
  if (start == std::string_view::npos) return kids;
  std::string_view list = pages.substr(start + 7, pages.find(']', start) - start - 7);
  while (const auto kid = number_behind(list, " ")) {
    kids.push_back(*kid);
    const std::size_t next = list.find(" R");
    if (next == std::string_view::npos) break;
    list.remove_prefix(next + 2);
  }
  return kids;
}

/// Returns a UTF-8 text as a PDF string: UTF-16 in hexadecimal digits.
std::string pdf_text(std::string_view text) {
  std::string digits = "<FEFF";
  while (const std::size_t length = text::utf8_length(text)) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    unsigned code = length == 1 ? byte(0) : byte(0) & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3Fu);
    if (code >= 0x10000u) {
      digits += fmt::format("{:04X}", 0xD7C0u + (code >> 10));
      code = 0xDC00u + (code & 0x3FFu);
    }
    digits += fmt::format("{:04X}", code);
    text.remove_prefix(length);
  }
  return digits + ">";
}

/// Objects of a PDF file that an outline depends on.
struct Structure {
  Number size = 0, root = 0, table = 0,
         pages = 0;          ///< count of objects, catalog, offset of the object table, list of pages
  std::vector<Number> kids;  ///< the pages
  std::string info;
};

std::optional<Structure> structure_of(std::string_view pdf) {
  const std::size_t at = pdf.rfind("\ntrailer");
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view trailer = pdf.substr(at);
  const auto size = number_behind(trailer, "/Size "), root = number_behind(trailer, "/Root ");
  const auto table = number_behind(trailer, "startxref\n");
  if (!size || !root || !table) return std::nullopt;
  const auto pages = number_behind(object_of(pdf, *root), "/Pages ");
  if (!pages) return std::nullopt;
  Structure found{*size, *root, *table, *pages, kids_of(object_of(pdf, *pages)), ""};
  if (const auto info = number_behind(trailer, "/Info ")) found.info = fmt::format(" /Info {} 0 R", *info);
  return found;
}

/// Appends objects to a PDF file and stores their offsets.
class Update {
 public:
  explicit Update(std::string& pdf) : pdf_(pdf) {}

  void add(Number number, const std::string& content) {
    rows_ += fmt::format("{} 1\n{:010} 00000 n \n", number, pdf_.size());
    pdf_ += fmt::format("{} 0 obj\n{}\nendobj\n", number, content);
  }

  void finish(const Structure& before, Number size) {
    const std::size_t table = pdf_.size();
    pdf_ += fmt::format("xref\n{}trailer\n<< /Size {} /Root {} 0 R{} /Prev {} >>\nstartxref\n{}\n%%EOF\n",
                        rows_, size, before.root, before.info, before.table, table);
  }

 private:
  std::string& pdf_;
  std::string rows_;
};

/// Returns the item of one bookmark; object numbers of items follow that of the outline.
std::string item_of(const std::vector<Bookmark>& bookmarks, std::size_t index, const Structure& of) {
  const Number outline = of.size, own = outline + 1 + index;
  const Bookmark& bookmark = bookmarks[index];
  std::string item = fmt::format("<< /Title {} /Parent {} 0 R /Dest [{} 0 R /Fit]", pdf_text(bookmark.title),
                                 outline, of.kids[bookmark.page - 1]);
  if (index > 0) item += fmt::format(" /Prev {} 0 R", own - 1);
  if (index + 1 < bookmarks.size()) item += fmt::format(" /Next {} 0 R", own + 1);
  return item + " >>";
}

}  // namespace

std::string with_outline(const std::string& pdf, const std::vector<Bookmark>& bookmarks) {
  const auto of = structure_of(pdf);
  const auto has_page = [&](const Bookmark& one) { return one.page >= 1 && one.page <= of->kids.size(); };
  if (!of || bookmarks.empty() || !std::ranges::all_of(bookmarks, has_page)) return pdf;
  std::string result = pdf;
  Update update(result);
  const Number last = of->size + bookmarks.size();
  update.add(of->root,
             fmt::format("<< /Type /Catalog /Pages {} 0 R /Outlines {} 0 R /PageMode /UseOutlines >>",
                         of->pages, of->size));
  update.add(of->size, fmt::format("<< /Type /Outlines /First {} 0 R /Last {} 0 R /Count {} >>", of->size + 1,
                                   last, bookmarks.size()));
  for (std::size_t i = 0; i < bookmarks.size(); ++i) update.add(of->size + 1 + i, item_of(bookmarks, i, *of));
  update.finish(*of, last + 1);
  return result;
}

}  // namespace stepwire::render
