#include "engine/figure/gallery.hpp"

#include <catch2/catch.hpp>

using namespace stepwire;

namespace {

Verdict verdict(const std::string& that, bool holds, const std::string& disagrees = "") {
  Verdict result{};
  result.that = that;
  result.check = "max x <= 2 N";
  result.shown = "1.5 N";
  result.holds = holds;
  result.disagrees = disagrees;
  return result;
}

GalleryEntry entry() {
  GalleryEntry result{};
  result.label = "Figure 15";
  result.title = "Force <over> the map";
  result.caption = "A & B";
  result.pictures = {"fig15/figure 1.svg"};
  result.diagram = "fig15.yaml";
  result.folder = "fig15";
  return result;
}

}  // namespace

TEST_CASE("the page tells how many claims hold and links to those that do not") {
  GalleryEntry one = entry(), two = entry();
  one.verdicts = {verdict("first", true), verdict("second", false)};
  two.verdicts = {verdict("third", false, "misprint"), verdict("fourth", true, "misprint")};
  const std::string page = gallery_page({"Title", "", {one, two}});
  CHECK_THAT(page,
             Catch::Contains("1 of 4 claims hold, 1 known not to hold, 1 does not hold, 1 holds after all."));
  CHECK_THAT(page, Catch::Contains(
                       "<a href=\"#entry-1\"><span class=\"label\">Figure 15</span> Force &lt;over&gt; the "
                       "map</a>: second – does not hold"));
  CHECK_THAT(page, Catch::Contains("fourth – holds after all"));
  CHECK_THAT(page, !Catch::Contains("third – "));
  CHECK_THAT(page, Catch::Contains("<em>misprint</em>"));
}

TEST_CASE("a page on which all holds says only that") {
  GalleryEntry one = entry();
  one.verdicts = {verdict("first", true)};
  const std::string page = gallery_page({"Title", "", {one}});
  CHECK_THAT(page, Catch::Contains("<p class=\"summary good\">1 of 1 claims hold.</p>"));
  CHECK_THAT(page, !Catch::Contains("class=\"failures\""));
}

TEST_CASE("texts are escaped, pictures have a description, and nothing is loaded from elsewhere") {
  GalleryEntry one = entry();
  one.assumptions = {{"speed", "10 mm/s", "of the \"push\""}};
  one.error = "a.yaml:1:1: <wrong>";
  const std::string page = gallery_page({"Title", "Introduction", {one}});
  CHECK_THAT(page, Catch::Contains(
                       "<img src=\"fig15/figure%201.svg\" alt=\"Figure 15: Force &lt;over&gt; the map\""));
  CHECK_THAT(page, Catch::Contains("<p>A &amp; B</p>"));
  CHECK_THAT(page, Catch::Contains("of the &quot;push&quot;"));
  CHECK_THAT(page, Catch::Contains("a.yaml:1:1: &lt;wrong&gt;"));
  CHECK_THAT(page, Catch::Contains("1 file did not run"));
  CHECK_THAT(page, !Catch::Contains("http"));
  CHECK_THAT(page, !Catch::Contains("<script"));
}

TEST_CASE("the front says what is reproduced by chapter, what disagrees and what is assumed, with links") {
  GalleryEntry one = entry(), two = entry();
  one.section = "2.5.1";
  one.verdicts = {verdict("first", true), verdict("second", false, "a <misprint>")};
  one.assumptions = {{"speed", "10 mm/s", "of the push"}};
  two.label = "Table 3";
  two.section = "4.3.1";
  two.verdicts = {verdict("third", true)};
  two.assumptions = {{"rig.speed", "10 mm/s", "of the push"}, {"a", "5 N", "offset"}};
  const std::string page = gallery_page({"Title", "", {one, two}});
  const std::size_t second = page.find("<h3>Chapter 2</h3>"), fourth = page.find("<h3>Chapter 4</h3>");
  REQUIRE(second != std::string::npos);
  REQUIRE(fourth != std::string::npos);
  const std::string of_second = page.substr(second, fourth - second);
  CHECK_THAT(of_second, Catch::Contains("href=\"#entry-1\"") && Catch::Contains("1 of 2") &&
                            !Catch::Contains("href=\"#entry-2\""));
  CHECK_THAT(page, Catch::Contains(">Figure 15</a>: second<br><em>a &lt;misprint&gt;</em>"));
  CHECK_THAT(page, Catch::Contains("2 values that the text does not give"));
  const std::size_t speed = page.find("<tr><td><code>speed</code></td>");
  REQUIRE(speed != std::string::npos);
  const std::string row = page.substr(speed, page.find("</tr>", speed) - speed);
  CHECK_THAT(row, Catch::Contains(">Figure 15</a>, <a href=\"#entry-2\"") && Catch::Contains(">Table 3</a>"));
}
