#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

TEST_CASE(
    "curves are dotted, solid and dashed in the order of the legend, and those without a style as before") {
  const PlotSpec plot =
      spec_of("{plot: lines, x: time, y: [rig.x, rig.x/2, rig.x/3, rig.x/4], style: [dots, line, dashes]}");
  using Dash = std::vector<double>;
  CHECK(mark<LineMark>(plot, 0).line == LineStyle{"#0072B2", 3.4, Dash{0.25, 1.75}});
  CHECK(mark<LineMark>(plot, 1).line == LineStyle{"#D55E00", 1.6, Dash{}});
  CHECK(mark<LineMark>(plot, 2).line == LineStyle{"#009E73", 1.4, Dash{4.0, 2.5}});
  CHECK(mark<LineMark>(plot, 3).line == LineStyle{"#CC79A7", 1.6, Dash{}});
  CHECK(mark<LineMark>(spec_of("{plot: lines, x: time, y: rig.x}"), 0).line.dash.empty());
}

TEST_CASE("another style is refused with those that there are") {
  CHECK_THAT(figures_of("{plot: xy, x: rig.x, y: rig.x, style: [wavy]}").faults,
             Contains("figure.style: 'wavy' is not allowed; it is one of: line, dashes, dots"));
}

TEST_CASE("each y of a plane has its own x where there are as many, else all have the one") {
  const PlotSpec plot =
      spec_of("{plot: xy, x: [rig.x in mm, 2*rig.x in mm], y: [rig.v in mm/s, rig.v in mm/s]}");
  const auto widest = [&](std::size_t index) {
    return geometry::extent_of(mark<LineMark>(plot, index).curves.at(0).x).high;
  };
  CHECK(widest(0) == Approx(1.0).epsilon(0.01));
  CHECK(widest(1) == Approx(2.0).epsilon(0.01));
  CHECK_THAT(figures_of("{plot: xy, x: [rig.x, rig.x], y: [rig.v, rig.v, rig.v]}").faults,
             Contains("figure.x: there are 2 in 'x' and 3 in 'y'; x is one, or one for each y"));
  CHECK_THAT(figures_of("{plot: xy, x: [rig.x, rig.v], y: [rig.v, rig.v]}").faults,
             Contains("figure.x: ") && Contains("one axis has one unit"));
}

TEST_CASE("a line whose curves are one point each is drawn as dots") {
  const PlotSpec plot = spec_of("{plot: lines, x: current, y: push.force}", {0.1, 0.2});
  const LineMark& points = mark<LineMark>(plot, 0);
  CHECK(points.dots > 0.0);
  REQUIRE(points.curves.size() == 2);
  CHECK(points.curves[1].x == std::vector<double>{0.2});
  CHECK(points.curves[1].y == std::vector<double>{5.0});
  CHECK(mark<LineMark>(spec_of("{plot: lines, x: time, y: push.force}"), 0).dots == 0.0);
}

TEST_CASE("a panel without a finite number says that beside what lies over it") {
  for (const std::string marks : {"", ", marks: {A: [0.5 s, 0 mm]}"}) {
    const PlotSpec plot =
        spec_of("{plot: lines, x: time, y: sqrt(0 - 1 - time/(1 s))*rig.x in mm" + marks + "}");
    REQUIRE_FALSE(plot.texts.empty());
    CHECK(
        std::ranges::any_of(plot.texts, [](const TextMark& text) { return text.text == "no rows to draw"; }));
  }
}

}  // namespace stepwire::plot
