#include "engine/view/svg/svg.hpp"

#include <catch2/catch.hpp>

namespace stepwire::svg {
using Catch::Contains;

namespace {

SvgElement dot(double x, const std::string& fill) {
  SvgElement circle{"circle"};
  circle.move("cx", x).set("cy", 2.0).set("fill", fill).set("class", "");
  SvgElement sheet{"svg"};
  return sheet.add(std::move(circle));
}

}  // namespace

TEST_CASE("what has a meaning in markup is written as its code") {
  CHECK(markup_escaped("a < b & \"c\" > d") == "a &lt; b &amp; &quot;c&quot; &gt; d");
}

TEST_CASE("numbers of a picture have two decimals at most and no sign at zero") {
  CHECK(svg_number(12.0) == "12");
  CHECK(svg_number(1.239) == "1.24");
  CHECK(svg_number(-0.001) == "0");
}

TEST_CASE("an element is text with its attributes, but those without a value") {
  CHECK(svg_text(dot(1.5, "a\"b")) == "<svg>\n<circle cx=\"1.5\" cy=\"2\" fill=\"a&quot;b\"/>\n</svg>\n");
  CHECK(svg_text({"text", {}, "1 < 2", {}}) == "<text>1 &lt; 2</text>\n");
}

TEST_CASE("in an animation places go evenly and colours jump when they change") {
  const std::string text = animated_svg({dot(0, "red"), dot(1, "red"), dot(4, "blue"), dot(9, "red")}, 6.0);
  CHECK_THAT(text, Contains("<circle cx=\"0\" cy=\"2\" fill=\"red\">\n"));
  CHECK_THAT(
      text,
      Contains("<animate attributeName=\"cx\" dur=\"6s\" repeatCount=\"indefinite\" values=\"0;1;4;9\"/>"));
  CHECK_THAT(text,
             Contains("attributeName=\"fill\" dur=\"6s\" repeatCount=\"indefinite\" calcMode=\"discrete\" "
                      "keyTimes=\"0;0.666667;1\" values=\"red;blue;red\"/>"));
  CHECK_THAT(text, !Contains("attributeName=\"cy\""));
  CHECK_THAT(text, !Contains("script"));
}

TEST_CASE("frames that are built differently are no animation") {
  CHECK_THROWS_WITH(animated_svg({dot(0, "red")}, 1.0), Contains("two frames"));
  CHECK_THROWS_WITH(animated_svg({dot(0, "red"), SvgElement{"svg"}}, 1.0),
                    Contains("differ in more than values"));
}

}  // namespace stepwire::svg
