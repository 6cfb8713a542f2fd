#include "engine/view/plot/drawn.hpp"
#include "engine/view/plot/overlay_drawing.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

const std::string plane = "plot: xy, x: rig.x in mm, y: rig.v in mm/s";
const std::string rose = "x: rig.x, y: rig.v, angle: 90 deg, value: push.force in N, radius: 2 mm";

table::Column constant(const std::string& name, const std::string& unit, double value, std::size_t rows) {
  return column(name, unit, std::vector<double>(rows, value));
}

/// A point that goes from (0, 0) to (8 mm, 0) in four equal rows, and back in one.
std::vector<record::Recording> there_and_back() {
  record::Recording recording;
  recording.table.columns = {column("time", "s", {0, 1, 2, 3, 4, 5}),
                             column("rig.x", "m", {0, 2e-3, 4e-3, 6e-3, 8e-3, 0}),
                             constant("rig.v", "m/s", 0, 6), constant("push.force", "N", 0, 6)};
  return {recording};
}

PlotSpec drawn_motion(const std::string& keys) {
  const Panel panel = panel_of("{" + plane + ", motion: {x: rig.x, y: rig.v" + keys + "}}");
  PlotBuilder plot(panel);
  plot.x = {0.0, 10.0};
  plot.y = {-1.0, 1.0};
  draw_motions(panel, there_and_back(), plot);
  return plot.spec;
}

using Numbers = std::vector<double>;

void check_near(const Numbers& found, const Numbers& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-12));
}

PlotSpec drawn_roses(const std::string& keys, const std::vector<record::Recording>& recordings) {
  const Panel panel = panel_of("{" + plane + ", rose: {" + keys + "}}");
  PlotBuilder plot(panel);
  draw_roses(panel, recordings, plot);
  return plot.spec;
}

}  // namespace

TEST_CASE("a motion is a line with arrow heads at even distances, that point along it") {
  const PlotSpec plot = drawn_motion(", heads: 2, color: blue, where: time < 4.5");
  CHECK(mark<LineMark>(plot, 0).line == LineStyle{"#0072B2", 2.0});
  // 8 mm, a head in the middle of each half, with a tail of a thousandth of the distance between heads
  const auto& heads = mark<VectorsMark>(plot, 1);
  check_near(heads.x, {2.0, 6.0});
  check_near(heads.dx, {0.004, 0.004});
  check_near(heads.dy, {0.0, 0.0});
}

TEST_CASE("the heads of a motion turn with it, and there may be none") {
  const PlotSpec plot = drawn_motion(", heads: 2");
  check_near(mark<VectorsMark>(plot, 1).x, {4.0, 4.0});
  check_near(mark<VectorsMark>(plot, 1).dx, {0.008, -0.008});
  CHECK(drawn_motion(", heads: 0").marks.size() == 1);
}

TEST_CASE("the axes reach as far as a motion and as the disc of a rose that stands beside its point") {
  const Panel panel =
      panel_of("{" + plane + ", motion: {x: rig.x, y: rig.v}, rose: {" + rose + ", at: [-20 mm, 0 mm/s]}}");
  PlotBuilder plot(panel);
  cover_motions(panel, there_and_back(), plot);
  CHECK(plot.x.high == Approx(8.0));
  cover_roses(panel, plot);
  CHECK(plot.x.low == Approx(-22.0));
  CHECK(plot.y.high == Approx(2.0));
}

TEST_CASE("a rose has a spoke for each row, the longest as long as its disc is wide") {
  record::Recording recording;
  recording.table.columns = {column("time", "s", {0, 1, 2}), constant("rig.x", "m", 1e-3, 3),
                             constant("rig.v", "m/s", 3e-3, 3), column("push.force", "N", {2, 8, 4})};
  const PlotSpec plot = drawn_roses(
      "x: rig.x, y: rig.v, angle: time*90 deg, value: push.force in N, radius: 4 mm, name: D2", {recording});
  REQUIRE(plot.marks.size() == 4);
  // along x 2 N of 8 N, straight up all of them, along -x 4 N: a quarter, all and half of 4 mm
  const auto& spokes = mark<VectorsMark>(plot, 2);
  check_near(spokes.x, {1.0, 1.0, 1.0});
  check_near(spokes.y, {3.0, 3.0, 3.0});
  check_near(spokes.dx, {1.0, 0.0, -2.0});
  check_near(spokes.dy, {0.0, 4.0, 0.0});
  CHECK(spokes.value == Numbers{2.0, 8.0, 4.0});
  REQUIRE(plot.texts.size() == 2);
  CHECK(plot.texts[0].text == "edge: 8 N");
  CHECK(plot.texts[0].y == Approx(-1.0));
  CHECK(plot.texts[1].text == "D2");
  CHECK(plot.texts[1].y == Approx(7.0));
}

TEST_CASE("a line leads from a rose that stands beside its point to the point") {
  const PlotSpec plot = drawn_roses(rose + ", at: [11 mm, 0 mm/s], where: time < 0.5", there_and_back());
  const MarkRows& leader = mark<LineMark>(plot, 2).curves.at(0);
  check_near(leader.x, {0.0, 9.0});
  check_near(leader.y, {0.0, 0.0});
}

TEST_CASE("claims may name what lies over a panel") {
  const auto read = figures_of(
      "{" + plane + ", motion: [{x: rig.x, y: rig.v}, {x: 2*rig.x, y: rig.v}], rose: {" + rose + "}}");
  REQUIRE(read.faults.empty());
  std::string names;
  for (const query::NamedFormula& one : drawn_quantities(read.figures, sample_names()))
    names += one.name + "=" + one.text + "\n";
  CHECK_THAT(names, Contains("figure.motion.x=rig.x\n") && Contains("figure.1.motion.2.x=2*rig.x\n") &&
                        Contains("figure.rose.value=push.force\n"));
}

TEST_CASE("motions and roses that cannot be drawn are refused where they stand") {
  CHECK_THAT(figures_of("{" + plane + ", motion: {x: rig.x}}").faults,
             Contains("figure.motion: 'y' is missing (up): {x: hand.1, y: hand.2}"));
  CHECK_THAT(figures_of("{" + plane + ", motion: {x: push.force, y: rig.v}}").faults,
             Contains("figure.motion.x: 'push.force' is in N, but 'rig.x' in m; both are drawn along x"));
  CHECK_THAT(figures_of("{" + plane + ", motion: {x: rig.x, y: rig.v, color: pink}}").faults,
             Contains("figure.motion.color: 'pink' is not allowed; it is one of: red, blue, green, black"));
  CHECK_THAT(figures_of("{" + plane + ", motion: {x: rig.x, y: slow, arrows: 3}}").faults,
             Contains("arrows") && Contains("recorded"));
  CHECK_THAT(figures_of("{" + plane + ", rose: {x: rig.x, y: rig.v}}").faults,
             Contains("figure.rose: 'angle' is missing"));
  CHECK_THAT(figures_of("{" + plane + ", rose: {" + rose + ", at: 3 mm}}").faults,
             Contains("figure.rose.at: takes two values: [0 mm, 20 mm]"));
  CHECK_THAT(figures_of("{plot: histogram, x: rig.x, motion: {x: rig.x, y: rig.v}}").faults,
             Contains("has no 'motion'"));
}

}  // namespace stepwire::plot
