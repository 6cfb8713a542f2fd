#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/figure/region_drawing.hpp"
#include "tests/engine/figure/samples.hpp"

using namespace stepwire;
using namespace stepwire::testing;
using Catch::Contains;

namespace {

const std::string plane = "plot: xy, x: rig.x in mm, y: rig.v in mm/s";

}  // namespace

TEST_CASE("a figure draws the boundary of a block by its name, in the units of its axes") {
  const Panel panel = panel_of("{" + plane + ", region: map}");
  Script script(panel, "p");
  cover_regions(panel, script);
  draw_regions(panel, script);
  CHECK_THAT(script.text(), Contains("\n-2 -2\n2 -2\n2 2\n-2 2\n-2 -2\n") && Contains("filledcurves closed"));
  CHECK(script.x.low == -2.0);
  CHECK(script.x.high == 2.0);
}

TEST_CASE("the boundary of a region is a line, or dashed where the file says so") {
  for (const bool dashed : {false, true}) {
    const Panel panel = panel_of("{" + plane + ", region: map" + (dashed ? ", region_line: dashes}" : "}"));
    Script script(panel, "p");
    script.x = script.y = {-5.0, 5.0};
    draw_regions(panel, script);
    CHECK((script.text().find("lw 1.6 dt 2 notitle") != std::string::npos) == dashed);
  }
  CHECK_THAT(figures_of("{" + plane + ", region: map, region_line: dots}").faults,
             Contains("'dots' is not allowed; it is one of line, dashes"));
}

TEST_CASE("a hole is run through against the sense of what is around it, so that it stays free") {
  const Panel panel = panel_of("{" + plane + ", region: [map]}");
  Script script(panel, "p");
  script.x = script.y = {-5.0, 5.0};
  draw_regions(panel, script);
  CHECK_THAT(script.text(), Contains("-2 -2\n-2 -2\n-2 -2\n-1 1\n1 1\n1 -1\n-1 -1\n-1 1\n-1 1\n-2 -2\n"));
}

TEST_CASE("the shade ends at the frame of the axes and lies below the curves") {
  const Panel panel = panel_of("{" + plane + ", region: map}");
  Script script(panel, "p");
  script.plot("1");
  script.x = {0.0, 5.0};
  script.y = {-5.0, 1.5};
  draw_regions(panel, script);
  CHECK_THAT(script.text(),
             Contains("plot $p1 using 1:2 with filledcurves") && Contains("2 1.5\n") && Contains("0 -2\n"));
  CHECK(script.text().find("filledcurves") < script.text().find("1 notitle, "));
}

TEST_CASE("an outline has no more points than can be seen") {
  constexpr double turn = 6.283185307179586;
  constexpr int points = 5000;
  Outline::Line circle;
  for (int i = 0; i <= points; ++i)
    circle.points.push_back({4e-3 * std::cos(turn * i / points), 4e-3 * std::sin(turn * i / points), 0.0});
  Panel panel = panel_of("{" + plane + "}");
  panel.regions = {{false, {circle}}};
  Script script(panel, "p");
  script.x = script.y = {-5.0, 5.0};
  draw_regions(panel, script);
  const std::string text = script.text();
  const std::string line = text.substr(0, text.find("EOD\n", text.find("EOD\n") + 4));
  const auto rows = std::count(line.begin(), line.end(), '\n');
  // A chord of a circle of radius 4 stays within 10 * 2.5e-4 of it for 2 acos(1 - 2.5e-3/4): 89 chords at
  // least.
  CHECK(rows > 89);
  CHECK(rows < 250);
}

TEST_CASE("a region that is none, or not of the plot's space, is refused") {
  CHECK_THAT(
      figures_of("{" + plane + ", region: mop}").faults,
      Contains("figure.region: 'mop' is no block with a boundary, as a Region is; did you mean 'map'?"));
  CHECK_THAT(figures_of("{" + plane + ", region: ball}").faults,
             Contains("'ball' lies in space, and a plot 'xy' shows the plane"));
  CHECK_THAT(figures_of("{plot: 3d, x: rig.x, y: rig.v, z: time, region: map}").faults,
             Contains("'map' lies in the plane, and a plot '3d' shows space"));
}
