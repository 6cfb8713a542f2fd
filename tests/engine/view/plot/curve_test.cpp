#include "engine/view/plot/gather.hpp"

#include <catch2/catch.hpp>

#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;

namespace {

geometry::Curves curves_of(const std::string& text, const record::Recording& recording) {
  const auto read = figures_of(text);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  const Panel& panel = read.figures.at(0).panels.at(0);
  return gather(panel, recording, {panel.find("x"), panel.find("y")});
}

}  // namespace

TEST_CASE("no curve goes from one run to the next") {
  const geometry::Curves all =
      curves_of("{plot: lines, x: time, y: rig.x in mm}", sample_recording({0.1, 0.2, 0.1}, 4));
  REQUIRE(all.curves.size() == 3);
  for (const geometry::Curve& curve : all.curves) {
    CHECK(curve.columns[0] == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
    CHECK(curve.columns[1][1] == Approx(1.0));
  }
  CHECK(all.labels.empty());
}

TEST_CASE("a swept parameter tells curves apart, and runs with the same value belong together") {
  const geometry::Curves all =
      curves_of("{plot: lines, x: time, y: rig.x, by: current in mA}", sample_recording({0.2, 0.1, 0.2}, 4));
  CHECK(all.labels == std::vector<std::string>{"100 mA", "200 mA"});
  REQUIRE(all.curves.size() == 3);
  CHECK(all.curves[0].group == 1);
  CHECK(all.curves[1].group == 0);
  CHECK(all.curves[2].group == 1);
}

TEST_CASE("swept words are the labels of their curves") {
  record::Recording recording = sample_recording({0, 1}, 4);
  recording.categories = {{"current", {"off", "on"}}};
  CHECK(curves_of("{plot: lines, x: time, y: rig.x, by: current}", recording).labels ==
        std::vector<std::string>{"off", "on"});
}

TEST_CASE("a curve is interrupted where rows are left out or are no numbers") {
  record::Recording recording = sample_recording({0.1}, 8);
  CHECK(curves_of("{plot: lines, x: time, y: rig.x, where: time != 0.5}", recording).curves.size() == 2);
  recording.table.columns[2].values[2] = NAN;
  const geometry::Curves all = curves_of("{plot: lines, x: time, y: rig.x}", recording);
  REQUIRE(all.curves.size() == 2);
  CHECK(all.curves[0].size() == 2);
  CHECK(all.curves[1].size() == 6);
}

TEST_CASE("the final rows of all runs make one curve") {
  const geometry::Curves all =
      curves_of("{plot: lines, x: current, y: push.force, rows: final, where: time < 0.9}",
                sample_recording({0.1, 0.2}, 4));
  REQUIRE(all.curves.size() == 1);
  CHECK(all.curves[0].columns[0] == std::vector<double>{0.1, 0.2});
  CHECK(all.curves[0].columns[1] == std::vector<double>{4.0, 5.0});
}

TEST_CASE("a logarithmic axis leaves out what is not above zero") {
  const geometry::Curves all =
      curves_of("{plot: lines, x: time, y: rig.x, log: y}", sample_recording({0.1}, 8));
  REQUIRE_FALSE(all.curves.empty());
  for (const geometry::Curve& curve : all.curves)
    for (const double value : curve.columns[1]) CHECK(value > 0.0);
}

}  // namespace stepwire::plot
