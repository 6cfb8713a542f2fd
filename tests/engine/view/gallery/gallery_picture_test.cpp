#include "engine/view/gallery/gallery_picture.hpp"

#include <catch2/catch.hpp>

#include "engine/base/mat/deflate.hpp"
#include "engine/base/text/base64.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::gallery {

TEST_CASE("the words of a picture name what is shown over what, as its axes do") {
  plot::Figure figure;
  figure.panels = {testing::panel_of("{plot: lines, x: time, y: [push.force, push.force]}")};
  CHECK(described(figure) == "force of push [N] over time [s]");
  figure.title = "All";
  figure.panels = {
      testing::panel_of("{plot: lines, x: time, y: push.force, y_label: force}"),
      testing::panel_of("{plot: map, x: rig.x in mm, y: rig.v, color: push.force, color_label: F}")};
  figure.panels[0].title = "A push";
  CHECK(described(figure) ==
        "All: A push, force [N] over time [s]; F [N] over x of rig [mm] and v of rig [m/s]");
}

TEST_CASE("size, title and ground are read from the text of a picture") {
  GalleryPicture picture;
  picture.alt = "a table";
  read_picture(
      picture,
      "<?xml version=\"1.0\"?>\n<svg \n width=\"700\" height=\"477.33\"\n><title>A &lt; B &amp;amp; C</title>"
      "<rect fill=\"#ffffff\"/></svg>");
  CHECK(picture.width == 700.0);
  CHECK(picture.height == 477.33);
  CHECK(picture.alt == "A < B &amp; C: a table");
  CHECK_FALSE(picture.dark);
  read_picture(picture,
               "<svg width=\"1\" height=\"2\"><style>@media (prefers-color-scheme: dark) {}</style><rect "
               "fill=\"#fff\"/></svg>");
  CHECK(picture.dark);
  CHECK(picture.alt == "A < B &amp; C: a table");
}

TEST_CASE("a script has the texts of pictures, packed by gzip, in base64") {
  // Base64 and gzip have tests of their own, the latter by zlib's inflate.
  CHECK(picture_script({{"a.svg", "<svg>\n\"\\</svg>"}}) ==
        "stepwirePictures(\"" + text::base64(mat::gzip_packed("{\"a.svg\":\"<svg>\\n\\\"\\\\</svg>\"}")) +
            "\");\n");
  CHECK(picture_script({{"a.svg", std::string(100000, 'a')}}).size() < 1000);
}

}  // namespace stepwire::gallery
