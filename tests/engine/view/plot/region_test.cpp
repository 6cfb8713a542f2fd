#include <catch2/catch.hpp>
#include <cmath>

#include "engine/view/plot/overlay_drawing.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

const std::string plane = "plot: xy, x: rig.x in mm, y: rig.v in mm/s";

PlotSpec drawn(const Panel& panel, const geometry::Extent& across, const geometry::Extent& up) {
  PlotBuilder plot(panel);
  plot.add(LineMark{});
  plot.x = across;
  plot.y = up;
  draw_regions(panel, plot);
  return plot.spec;
}

const geometry::Extent wide{-5.0, 5.0};
using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("a figure draws the boundary of a block by its name, in the units of its axes") {
  const Panel panel = panel_of("{" + plane + ", region: map}");
  PlotBuilder plot(panel);
  cover_regions(panel, plot);
  CHECK(plot.x.low == -2.0);
  CHECK(plot.x.high == 2.0);
  const PlotSpec spec = drawn(panel, plot.x, plot.y);
  REQUIRE(spec.marks.size() == 3);
  const MarkRows& line = mark<LineMark>(spec, 2).curves.at(0);
  CHECK(line.x == Numbers{-2.0, 2.0, 2.0, -2.0, -2.0});
  CHECK(line.y == Numbers{-2.0, -2.0, 2.0, 2.0, -2.0});
}

TEST_CASE("the boundary of a region is a line, or dashed where the file says so") {
  for (const bool dashed : {false, true}) {
    const Panel panel = panel_of("{" + plane + ", region: map" + (dashed ? ", region_line: dashes}" : "}"));
    CHECK(mark<LineMark>(drawn(panel, wide, wide), 2).line.dash.empty() != dashed);
  }
  CHECK_THAT(figures_of("{" + plane + ", region: map, region_line: dots}").faults,
             Contains("'dots' is not allowed; it is one of: line, dashes"));
}

TEST_CASE("a hole is run through against the sense of what is around it, so that it stays free") {
  const auto spec = drawn(panel_of("{" + plane + ", region: [map]}"), wide, wide);
  const auto& shade = mark<AreaMark>(spec, 0);
  double area = 0.0;  // area between two squares of 4 and 2 mm by the shoelace formula
  for (std::size_t i = 0; i + 1 < shade.x.size(); ++i)
    area += 0.5 * (shade.x[i] * shade.y[i + 1] - shade.x[i + 1] * shade.y[i]);
  CHECK(area == Approx(16.0 - 4.0));
}

TEST_CASE("the shade ends at the frame of the axes and lies below the curves") {
  const PlotSpec spec = drawn(panel_of("{" + plane + ", region: map}"), {0.0, 5.0}, {-5.0, 1.5});
  const auto& shade = mark<AreaMark>(spec, 0);
  CHECK(geometry::extent_of(shade.x).low == 0.0);
  CHECK(geometry::extent_of(shade.x).high == 2.0);
  CHECK(geometry::extent_of(shade.y).high == 1.5);
}

TEST_CASE("an outline has no more points than can be seen") {
  constexpr double turn = 6.283185307179586;
  constexpr int points = 5000;
  Outline::Line circle;
  for (int i = 0; i <= points; ++i)
    circle.points.push_back({4e-3 * std::cos(turn * i / points), 4e-3 * std::sin(turn * i / points), 0.0});
  Panel panel = panel_of("{" + plane + "}");
  panel.regions = {{"disc", {false, {circle}}}};
  const auto rows = mark<LineMark>(drawn(panel, wide, wide), 2).curves.at(0).x.size();
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

}  // namespace stepwire::plot
