#include "engine/view/render/pdf_outline.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

using Catch::Contains;
using Catch::StartsWith;

namespace stepwire::render {
namespace {

/// A file of two pages, as Cairo lays it out.
std::string two_pages() {
  std::string pdf = "%PDF-1.5";
  for (const char* content : {"1 0 obj\n<< /Type /Pages\n   /Kids [ 3 0 R 4 0 R ]\n   /Count 2\n>>",
                              "2 0 obj\n<< /Type /Catalog\n   /Pages 1 0 R\n>>", "3 0 obj\n<< /Type /Page >>",
                              "4 0 obj\n<< /Type /Page >>"})
    pdf += fmt::format("\n{}\nendobj", content);
  return pdf + "\nxref\n0 5\ntrailer\n<< /Size 5\n   /Root 2 0 R\n>>\nstartxref\n217\n%%EOF\n";
}

TEST_CASE("an outline is added behind a PDF file, with the page of each bookmark") {
  const std::string pdf = two_pages(), with = with_outline(pdf, {{"Figure 1", 1}, {"Größe", 2}});
  CHECK_THAT(with, StartsWith(pdf));
  const std::string added = with.substr(pdf.size());
  CHECK_THAT(added, Contains("2 0 obj\n<< /Type /Catalog /Pages 1 0 R /Outlines 5 0 R"));
  CHECK_THAT(added, Contains("/First 6 0 R /Last 7 0 R /Count 2"));
  CHECK_THAT(added, Contains("6 0 obj\n<< /Title <FEFF00460069006700750072006500200031> /Parent 5 0 R /Dest "
                             "[3 0 R /Fit] /Next 7 0 R"));
  CHECK_THAT(added, Contains("<FEFF0047007200F600DF0065> /Parent 5 0 R /Dest [4 0 R /Fit] /Prev 6 0 R >>"));
  CHECK_THAT(added, Contains("/Size 8 /Root 2 0 R /Prev 217 >>"));
}

TEST_CASE("each offset in the table of an outline is that of its object") {
  const std::string with = with_outline(two_pages(), {{"a", 1}});
  const std::size_t table = std::stoul(with.substr(with.rfind("startxref\n") + 10));
  REQUIRE(with.substr(table, 5) == "xref\n");
  for (const int object : {2, 5, 6}) {
    const std::string row = fmt::format("\n{} 1\n", object);
    const std::size_t at = with.find(row, table);
    REQUIRE(at != std::string::npos);
    const std::size_t offset = std::stoul(with.substr(at + row.size(), 10));
    CHECK(with.substr(offset, 7) == fmt::format("{} 0 obj", object));
  }
}

TEST_CASE("a PDF file without a plain table, or without the page, stays as it is") {
  CHECK(with_outline("%PDF-1.7\nstartxref\n12\n%%EOF\n", {{"a", 1}}) == "%PDF-1.7\nstartxref\n12\n%%EOF\n");
  CHECK(with_outline(two_pages(), {{"a", 3}}) == two_pages());
  CHECK(with_outline(two_pages(), {}) == two_pages());
}

}  // namespace
}  // namespace stepwire::render
