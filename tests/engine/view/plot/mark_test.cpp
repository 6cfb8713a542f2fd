#include "engine/view/plot/overlay_drawing.hpp"
#include "engine/view/render/render.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

const std::string plane = "plot: xy, x: rig.x in mm, y: rig.v in mm/s";

/// The texts of a panel whose axes go from -10 to 10, over a curve.
std::vector<TextMark> drawn(const Panel& panel, const MarkRows& curve = {}) {
  PlotBuilder plot(panel);
  plot.x = plot.y = {-10.0, 10.0};
  plot.add(LineMark{{curve}});
  draw_marks(panel, 400.0, 300.0, plot);
  return plot.spec.texts;
}

using Align = TextMark::Align;

}  // namespace

TEST_CASE("marks are points by their names in the units of the axes, and a list of them is numbered") {
  const auto named = panel_of("{" + plane + ", marks: {A: [1 mm, 2 mm/s], \"1\": [-0.001 m, $low]}}").marks;
  REQUIRE(named.size() == 2);
  CHECK(named[0].name == "A");
  CHECK(named[0].x == Approx(1.0));
  CHECK(named[0].y == Approx(2.0));
  CHECK(named[1].name == "1");
  CHECK(named[1].x == Approx(-1.0));
  CHECK(named[1].y == Approx(-2000.0));
  const auto numbered = panel_of("{" + plane + ", marks: [[0, 0], [1 mm, 0]]}").marks;
  REQUIRE(numbered.size() == 2);
  CHECK(numbered[0].name == "1");
  CHECK(numbered[1].name == "2");
}

TEST_CASE("the axes reach as far as the marks") {
  const Panel panel = panel_of("{" + plane + ", marks: {A: [3 mm, -7 mm/s]}}");
  PlotBuilder plot(panel);
  cover_marks(panel, plot);
  CHECK(plot.x.high == Approx(3.0));
  CHECK(plot.y.low == Approx(-7.0));
}

TEST_CASE("a mark lies in front of all curves, with its name aslant above it where nothing is in the way") {
  const auto texts = drawn(panel_of("{" + plane + ", marks: {\"it's\": [1 mm, 2 mm/s]}}"));
  REQUIRE(texts.size() == 3);
  for (const TextMark& text : texts) CHECK(std::pair(text.x, text.y) == std::pair(1.0, 2.0));
  CHECK(texts[0].dot > texts[1].dot);
  CHECK(texts[2].text == "it's");
  CHECK(texts[2].align == Align::left);
  CHECK(texts[2].offset == std::array{0.7, 0.6});
  CHECK(texts[2].rim);
}

TEST_CASE("a name stays clear of a curve, of other marks and of the frame") {
  const Panel alone = panel_of("{" + plane + ", marks: {A: [0 mm, 0 mm/s]}}");
  // A curve that comes from the right above, as steep as one letter is high and wide: only the other side is
  // free.
  CHECK(drawn(alone, {{0.0, 5.0}, {0.0, 7.0}, {}, {}})[2].align == Align::right);
  const auto corner = drawn(panel_of("{" + plane + ", marks: {A: [9.9 mm, 9.9 mm/s]}}"));
  CHECK(corner[2].align == Align::right);
  CHECK(corner[2].offset == std::array{-0.7, -0.6});
  const auto pair = drawn(panel_of("{" + plane + ", marks: {A: [0 mm, 0 mm/s], B: [0.6 mm, 0.7 mm/s]}}"));
  CHECK((pair[2].align != Align::left || pair[2].offset != std::array{0.7, 0.6}));
}

TEST_CASE("the name of a mark has a white rim in the picture, so that it is read on arrows and colours") {
  const auto read = figures_of("{" + plane + ", marks: {Q: [0 mm, 0 mm/s]}}");
  REQUIRE(read.faults.empty());
  const std::string svg = render::draw(read.figures.at(0), sample_recordings({0.0}, 20)).svg;
  const std::size_t name = svg.find("<text>Q</text>");
  REQUIRE(name != std::string::npos);
  CHECK_THAT(svg.substr(svg.rfind("<g", name), 300), Contains("paint-order:stroke") && Contains("#ffffff"));
}

TEST_CASE("marks that are no points of the plane are refused where they stand") {
  CHECK_THAT(figures_of("{" + plane + ", marks: {A: [1 N, 0]}}").faults,
             Contains("d.yaml:1:") && Contains("figure.marks: 1 N is in N, but 'rig.x' is in m"));
  CHECK_THAT(figures_of("{" + plane + ", marks: {A: 3 mm}}").faults,
             Contains("figure.marks: the mark 'A' lies at two numbers, its x and its y: [0 mm, 20 mm]"));
  CHECK_THAT(figures_of("{" + plane + ", marks: {A: [1, 2, 3]}}").faults, Contains("two numbers"));
  CHECK_THAT(figures_of("{" + plane + ", marks: A}").faults,
             Contains("figure.marks: marks are points with names"));
  CHECK_THAT(figures_of("{" + plane + ", x_range: [0 mm, 1 mm], marks: {A: [2 mm, 0]}}").faults,
             Contains("the mark 'A' lies beyond the range of its axes"));
  CHECK_THAT(figures_of("{plot: 3d, x: rig.x, y: rig.v, z: time, marks: {A: [0, 0]}}").faults,
             Contains("a plot '3d'") && Contains("'marks'"));
  CHECK_THAT(figures_of("{plot: strip, x: time, color: rig.v, marks: {A: [0, 0]}}").faults,
             Contains("'marks'"));
}

TEST_CASE("texts stand about their points, which the axes reach, and have no dot") {
  const Panel panel = panel_of("{" + plane + ", texts: {authorized region: [3 mm, -7 mm/s]}}");
  REQUIRE(panel.texts.size() == 1);
  PlotBuilder plot(panel);
  cover_marks(panel, plot);
  CHECK(plot.x.high == Approx(3.0));
  CHECK(plot.y.low == Approx(-7.0));
  draw_texts(panel, plot);
  REQUIRE(plot.spec.texts.size() == 1);
  CHECK(plot.spec.texts[0] ==
        TextMark{.text = "authorized region", .x = 3.0, .y = -7.0, .color = "#101010", .rim = true});
}

TEST_CASE("texts that are nowhere in the plane are refused where they stand") {
  CHECK_THAT(figures_of("{" + plane + ", texts: [[1, 2]]}").faults,
             Contains("figure.texts: texts stand about points: {authorized region: [0 mm, 200 mm]}"));
  CHECK_THAT(figures_of("{" + plane + ", texts: {A: [2 mm, 0]}, x_range: [0 mm, 1 mm]}").faults,
             Contains("figure.texts: the text 'A' lies beyond the range of its axes"));
}

}  // namespace stepwire::plot
