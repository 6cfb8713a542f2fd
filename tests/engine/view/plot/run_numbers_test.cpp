// Reductions in figures: a point for each run, by the reductions of claims.
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

/// x = sin(2 pi t) mm in three runs; the force is 3 + 10 current N.
const std::vector<double> currents{0.1, 0.2, 0.4};

LineMark line_of(const std::string& text) {
  return mark<LineMark>(spec_of(text, currents, 400), 0);
}

}  // namespace

TEST_CASE("a figure that reduces has a point for each run, in the unit of its axis") {
  const LineMark line =
      line_of("{plot: lines, x: current in mA, y: max(push.force) - min(push.force)/2 in mN}");
  REQUIRE(line.curves.size() == 1);
  for (std::size_t run = 0; run < currents.size(); ++run) {
    CHECK(line.curves[0].x.at(run) == Approx(1000.0 * currents[run]));
    CHECK(line.curves[0].y.at(run) == Approx(500.0 * (3.0 + 10.0 * currents[run])));
  }
}

TEST_CASE("a reduction has its own condition, and that of the panel before it") {
  // The root mean square of a sine is that of its first half.
  CHECK(line_of("{plot: lines, x: current, y: rms(rig.x where time <= 0.5 s) in mm}").curves[0].y.at(1) ==
        Approx(std::sqrt(0.5)).epsilon(1e-3));
  const LineMark some =
      line_of("{plot: lines, x: current, y: min(rig.x) in mm, where: time <= 0.5 s && current > 0.15}");
  REQUIRE(some.curves[0].x.size() == 2);
  CHECK(some.curves[0].x[0] == Approx(0.2));
  CHECK(some.curves[0].y[0] == Approx(0.0).margin(1e-9));
}

TEST_CASE("both axes and histograms may reduce") {
  const LineMark line = line_of("{plot: xy, x: mean(push.force), y: final(rig.v)/max(rig.v)}");
  CHECK(line.curves[0].x.at(2) == Approx(7.0));
  CHECK(line.curves[0].y.at(2) == Approx(1.0));
  const PlotSpec bins = spec_of("{plot: histogram, x: max(push.force), bins: 2}", currents, 10);
  CHECK(mark<RectanglesMark>(bins, 0).y_high == std::vector<double>{2.0, 1.0});
}

TEST_CASE("labels and what is wrong are those of the expression") {
  CHECK(spec_of("{plot: lines, x: current, y: max(rig.x) in mm}", currents).y.label == "max(rig.x)");
  CHECK(spec_of("{plot: lines, x: current, y: {signal: max(rig.x) in mm, label: peak}}", currents).y.label ==
        "peak");
  CHECK_THAT(figures_of("{plot: lines, x: time, y: max(rig.x)}").faults,
             Contains("'time' has many values in a run; reduce it, as in max(time)"));
  CHECK_THAT(figures_of("{plot: lines, x: current, y: [max(rig.x), rig.x]}").faults,
             Contains("figure.y: 'rig.x' has many values in a run"));
  CHECK_THAT(figures_of("{plot: lines, x: current, y: max(rig.x) - rig.x}").faults,
             Contains("1:43: figure.y: 'rig.x' is no number of a run"));
  CHECK_THAT(figures_of("{plot: lines, x: current, y: max(rig.x) in N}").faults,
             Contains("cannot be drawn in N"));
  CHECK_THAT(figures_of("{plot: lines, x: current, y: max(rig.y)}").faults,
             Contains("'rig.y' is not recorded"));
}

}  // namespace stepwire::plot
