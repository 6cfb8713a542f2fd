#include "engine/base/text/text_table.hpp"
#include "engine/view/svg/table_drawing.hpp"

#include <catch2/catch.hpp>

namespace stepwire::text {
using Catch::Matchers::Contains;

namespace {

const TextTable sample{
    "Means", {"condition", "P", "in words"}, {{"NO", "2.02e-05", "small"}, {"HV_gp", "–", "none"}}, {}};

}  // namespace

TEST_CASE("numbers are set to the right and words to the left") {
  CHECK(text(sample) ==
        "Means\n"
        "condition         P  in words\n"
        "-----------------------------\n"
        "NO         2.02e-05  small\n"
        "HV_gp             –  none\n");
}

TEST_CASE("letters beyond ASCII take one place") {
  const TextTable greek{"η", {"term", "η²"}, {{"a", "0.5"}}, {}};
  CHECK(text(greek) == "η\nterm   η²\n---------\na     0.5\n");
}

TEST_CASE("notes are wrapped below the table") {
  TextTable table = sample;
  table.notes = {
      "This sentence has so many words that it cannot stand in one line of eighty letters any more."};
  CHECK_THAT(text(table), Contains("letters\nany more.\n") || Contains("eighty\nletters any more.\n"));
}

TEST_CASE("the picture holds every cell, with what SVG reserves replaced") {
  TextTable table = sample;
  table.rows.push_back({"<a & b>", "1", ""});
  const std::string svg = svg::draw(table);
  CHECK_THAT(svg, Contains(">HV_gp</text>") && Contains(">2.02e-05</text>") && Contains("&lt;a &amp; b&gt;"));
  CHECK(svg.starts_with("<svg "));
}

}  // namespace stepwire::text
