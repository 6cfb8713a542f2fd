#include "engine/view/gallery/gallery_picture.hpp"

#include <catch2/catch.hpp>

using Catch::Contains;

namespace stepwire::gallery {
namespace {

GalleryEntry entry() {
  GalleryEntry one;
  one.label = "Figure 15";
  one.title = "A strip";
  one.source_caption = "Force over a 1-D map & more.";
  return one;
}

const std::string picture_svg = "<?xml version=\"1.0\"?>\n<svg width=\"300\" height=\"200\"><g/></svg>";

TEST_CASE("a printed page has the picture, and below it number and caption of the thesis") {
  const GalleryPicture picture{"figure.svg", "", "The left half.", "", 300.0, 200.0};
  const std::string page = printed_page(entry(), picture, picture_svg);
  CHECK_THAT(page, Contains("width=\"620\" height=\"280\""));
  CHECK_THAT(page, Contains("<svg x=\"160\" y=\"30\"  width=\"300\" height=\"200\"><g/></svg>"));
  CHECK_THAT(page, !Contains("<?xml"));
  CHECK_THAT(
      page,
      Contains(
          "<tspan font-weight=\"bold\">Figure 15.</tspan> Force over a 1-D map &amp; more. The left half."));
}

TEST_CASE("a printed page names a picture that the thesis has not, and breaks a long caption") {
  GalleryPicture picture{"figure-2.svg", "", "", "", 300.0, 200.0};
  picture.own = true;
  for (int i = 0; i < 40; ++i) picture.caption += "eleven letters ";
  const std::string page = printed_page(entry(), picture, picture_svg);
  CHECK_THAT(page, Contains(">Figure 15, not in the thesis.</tspan> eleven letters"));
  CHECK_THAT(page, !Contains("1-D map"));
  std::size_t lines = 0;
  for (std::size_t at = page.find("<text"); at != std::string::npos; at = page.find("<text", at + 1)) ++lines;
  CHECK(lines > 5);
}

TEST_CASE("the name of an entry in a list of pages has its number and title") {
  CHECK(printed_name(entry()) == "Figure 15: A strip");
  GalleryEntry plain;
  plain.title = "A strip";
  CHECK(printed_name(plain) == "A strip");
}

}  // namespace
}  // namespace stepwire::gallery
