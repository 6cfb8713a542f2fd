#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;

namespace {

std::string faults_of(const std::string& text) {
  return figures_of(text).faults;
}

}  // namespace

TEST_CASE("an axis is labelled with its expression and the unit it is drawn in") {
  const Panel panel =
      panel_of("{plot: lines, x: time, y: [abs(rig.x) in mm, {signal: rig.x in mm, label: place}]}");
  CHECK(panel.find("x")->axis_label() == "time [s]");
  CHECK(panel.series.at("y")[0].axis_label() == "abs(rig.x) [mm]");
  CHECK(panel.series.at("y")[1].axis_label() == "place [mm]");
}

TEST_CASE("the SI unit of an expression is its unit where none is given") {
  CHECK(panel_of("{plot: xy, x: rig.x, y: push.force*rig.v}").series.at("y")[0].axis_label() ==
        "push.force*rig.v [W]");
  CHECK(panel_of("{plot: xy, x: rig.x, y: rig.x / 3 mm}").series.at("y")[0].axis_label() ==
        "rig.x / 3 mm [–]");
  CHECK(panel_of("{plot: xy, x: rig.x, y: rig.x > 0}").series.at("y")[0].axis_label() == "rig.x > 0 [–]");
  CHECK(panel_of("{plot: xy, x: rig.x, y: rig.x + 5 mm}").series.at("y")[0].axis_label() ==
        "rig.x + 5 mm [m]");
}

TEST_CASE("on an axis with a unit a formula without one is refused") {
  CHECK(faults_of("{plot: lines, x: time, y: [push.force, 3 + 10*current]}") ==
        "d.yaml:1:40: figure.y: 'push.force' is drawn in N, but the unit of '3 + 10*current' is not known; "
        "name "
        "its SI unit behind it, as '3 + 10*current in N'\n");
  CHECK(faults_of("{plot: lines, x: time, y: [3 + 10*current, push.force in kN]}") != "");
  CHECK(faults_of("{plot: lines, x: time, y: [push.force, 3 + 10*current in N]}").empty());
  CHECK(faults_of("{plot: lines, x: time, y: 3 + 10*current}").empty());
  CHECK(faults_of("{plot: lines, x: time, y: 3 + 10*current, y_range: [0 N, 5 N]}") != "");
  CHECK(faults_of("{plot: lines, x: time, y: rig.x in mm, reference: 3 + 10*current}") != "");
  CHECK(panel_of("{plot: lines, x: time, y: [rig.x in mm, 0.02 m in mm]}")
            .series.at("y")[1]
            .unit.from_si(0.02) == 20.0);
}

TEST_CASE("a number without unit on an axis whose unit is not SI is refused, as in claims") {
  const std::string plot = "{plot: lines, x: time in ms, y: rig.x in mm";
  const std::string wrong = "5 has no unit, but 'rig.x' is in mm; write 5 mm";
  CHECK(
      faults_of(plot + ", y_range: [-5, 5 mm]}").find("-5 has no unit, but 'rig.x' is in mm; write -5 mm") !=
      std::string::npos);
  for (const char* keys : {", reference: 5}", ", low: 5, high: rig.x}"})
    CHECK(faults_of(plot + keys).find(wrong) != std::string::npos);
  CHECK(faults_of("{plot: lines, x: time, y: [rig.x in mm, 5]}").find(wrong) != std::string::npos);
  CHECK(faults_of("{plot: histogram, x: rig.x in mm, lines: [5, 2 mm]}").find(wrong) != std::string::npos);
  CHECK(faults_of("{plot: xy, x: rig.x in mm, y: rig.v, marks: {A: [5, 1]}}").find(wrong) !=
        std::string::npos);
  CHECK(faults_of("{plot: map, x: rig.x in mm, y: rig.v, color: time, gap: 5}").find(wrong) !=
        std::string::npos);
  CHECK(faults_of(plot + ", x_range: [0, 20]}").find("20 has no unit, but 'time' is in ms; write 20 ms") !=
        std::string::npos);
  CHECK(faults_of("{plot: lines, x: time, y: rig.x*(1 K/1 m) in degC, y_range: [0, 30]}")
            .find("write 30 degC") != std::string::npos);
  CHECK(faults_of(plot + ", y_range: [0, 5 mm], x_range: [0, 1 s], reference: 0}").empty());
  CHECK(faults_of("{plot: lines, x: time, y: rig.x, y_range: [-0.5, 0.5], reference: 0.3}").empty());
  CHECK(faults_of("{plot: lines, x: time, y: rig.x in mm, reference: $reach}").empty());
}

TEST_CASE("ranges and options become the unit of their axis") {
  const Panel panel =
      panel_of("{plot: map, x: rig.x in mm, y: rig.x, color: push.force, x_range: [-5 mm, 0.01 m]}");
  CHECK(panel.x.range == std::array{-5.0, 10.0});
  const auto unknown_cells = [](const std::string& gap) {
    const PlotSpec plot =
        spec_of("{plot: map, x: rig.x in mm, y: rig.v in mm/s, color: time, cells: 40, gap: " + gap + "}");
    return std::ranges::count_if(mark<ImageMark>(plot, 0).values, [](double one) { return std::isnan(one); });
  };
  CHECK(unknown_cells("2 mm") == unknown_cells("0.002 m"));
  CHECK(unknown_cells("2 mm") < unknown_cells("0.01 mm"));
  // The force is 3 N + 10 N/A of the current, so 4.5 N are at 0.15 A.
  const PlotSpec map = spec_of("{plot: map, x: time, y: current, color: push.force in kN, contour: 4.5 N}",
                               {0.1, 0.2, 0.3}, 4);
  const std::vector<double>& level = mark<LineMark>(map, 1).curves.at(0).y;
  REQUIRE(level.size() > 1);
  CHECK(std::ranges::all_of(level, [](double y) { return std::abs(y - 0.15) < 1e-12; }));
}

TEST_CASE("a panel has the options of its kind, and those of a new struct before any is set") {
  struct Options {
    double cells = 24.0;
  };
  Panel panel;
  CHECK(std::as_const(panel).options<Options>().cells == 24.0);
  panel.options<Options>().cells = 3.0;
  const Panel copy = panel;
  panel.options<Options>().cells = 4.0;
  CHECK(copy.options<Options>().cells == 3.0);
}

TEST_CASE("the edges of a band and a reference are in the unit of their axis") {
  const Panel panel = panel_of(
      "{plot: lines, x: time, y: rig.x in mm, low: rig.x - 1 mm, high: rig.x + 1 mm in um, reference: "
      "rig.x}");
  for (const char* key : {"low", "high", "reference"}) CHECK(panel.find(key)->unit.from_si(0.002) == 2.0);
  const std::string plot = "{plot: lines, x: time, y: rig.x in mm, ";
  CHECK(faults_of(plot + "low: push.force, high: rig.x}") ==
        "d.yaml:1:45: figure.low: 'rig.x' is drawn in mm, but 'push.force' in N; one axis has one unit: give "
        "each a panel\n");
  CHECK(faults_of(plot + "low: 3 + 10*current, high: rig.x}") != "");
  CHECK(faults_of(plot + "low: rig.x}") == "d.yaml:1:45: figure.low: goes with 'high', which is not given\n");
  CHECK(faults_of("{plot: lines, x: time, y: 3 + 10*current, reference: rig.x}") != "");
  CHECK(faults_of("{plot: field, x: rig.x, y: rig.x, u: push.force, v: rig.v}") != "");
}

TEST_CASE("a reference has the meaning of its axis") {
  CHECK(faults_of("{plot: box, y: rig.v/1 m in rpm, reference: 5 Hz}") ==
        "d.yaml:1:45: figure.reference: '5 Hz' counts periods per time, of which each has 2*pi rad; write it "
        "in "
        "rad/s\n");
  CHECK(faults_of("{plot: box, y: rig.v/1 m in rpm, reference: rig.v/1 m in Hz}") != "");
  CHECK(faults_of("{plot: box, y: rig.v/1 m in rpm, reference: 5 rad/s}").empty());
  CHECK(faults_of("{plot: box, y: rig.x*(1 K/1 m) in degC, reference: 5 delta_degC}") != "");
  CHECK(faults_of("{plot: box, y: rig.x*(1 delta_degC/1 m) in K, reference: 20 K}").empty());
}

TEST_CASE("one entry, a list of entries and panels give pictures") {
  CHECK(figures_of("{plot: lines, x: time, y: rig.x}").figures.size() == 1);
  const auto read = figures_of(
      "- {plot: lines, x: time, y: rig.x, title: a, caption: b, size: [300, 200]}\n"
      "- {title: c, columns: 3, panels: [{plot: lines, x: time, y: rig.x, title: d}, {plot: box, y: "
      "rig.x}]}\n");
  REQUIRE(read.faults.empty());
  CHECK(read.figures[0].title == "a");
  CHECK(read.figures[0].caption == "b");
  CHECK(read.figures[0].width == 300);
  CHECK(read.figures[1].columns == 3);
  CHECK(read.figures[1].panels.at(0).title == "d");
}

TEST_CASE("what a figure asks wrongly is told with its place") {
  CHECK_THAT(faults_of("{plot: lnes, x: time}"),
             Catch::StartsWith(
                 "d.yaml:1:8: figure.plot: there is no plot 'lnes'; did you mean 'lines'? There are: lines"));
  CHECK(faults_of("{plot: lines, x: time}") ==
        "d.yaml:1:1: figure.y: a plot 'lines' needs 'y': one expression or a list of them\n");
  CHECK(faults_of("{plot: lines, x: time, y: rig.x in N}") ==
        "d.yaml:1:36: figure.y: 'rig.x' is in m and cannot be drawn in N\n");
  CHECK(faults_of("{plot: lines, x: time, y: rig.x in foo}") == "d.yaml:1:36: figure.y: 'foo' is no unit\n");
  CHECK_THAT(faults_of("{plot: lines, x: time, y: 2*rig.q in mm}"),
             Catch::StartsWith("d.yaml:1:29: figure.y: 'rig.q' is not recorded; did you mean 'rig.x'?"));
  CHECK(faults_of("{plot: lines, x: time, y: [rig.x, push.force]}") ==
        "d.yaml:1:35: figure.y: 'rig.x' is drawn in m, but 'push.force' in N; one axis has one unit: give "
        "each a "
        "panel\n");
  CHECK(faults_of("{plot: lines, x: time, y: rig.x, x_range: [5 N, 6 s]}") ==
        "d.yaml:1:44: figure.x_range: 5 N is in N, but 'time' is in s; write it in s\n");
  CHECK(faults_of("{plot: map, x: time, y: time, color: time, boundary: z}") ==
        "d.yaml:1:54: figure.boundary: 'z' is no coordinate of the plane, nor recorded; there are: x, y, "
        "time, current, rig.x, rig.v, push.force, slow\n");
  CHECK_THAT(faults_of("{plot: path, x: rig.x, y: time, color: time, boundary: y - 0.1 m}"),
             Catch::StartsWith("d.yaml:1:58: figure.boundary: ") && Catch::Contains("s"));
  CHECK(faults_of("{plot: path, x: rig.x in mm, y: time, color: time, boundary: x - 1 mm}").empty());
  CHECK_THAT(faults_of("{plot: lines, x: time, y: rig.x, colour: 3}"),
             Catch::StartsWith(
                 "d.yaml:1:34: figure: a plot 'lines' has no 'colour'; it has: plot, x, y, low, high, by, "));
  CHECK(faults_of("{plot: lines, x: time, y: rig.x, legend: [a, b]}") ==
        "d.yaml:1:42: figure.legend: there are 2 texts, but only 1 in 'y'; 'by' with a swept parameter tells "
        "runs "
        "apart\n");
  CHECK(faults_of("[3]") == "d.yaml:1:2: figure: a figure is a map: {plot: lines, x: time, y: rig.x}\n");
}

TEST_CASE("columns that were recorded apart share a plot only as curves of their own") {
  CHECK(faults_of("{plot: lines, x: time, y: [push.force, slow]}").empty());
  CHECK(panel_of("{plot: lines, x: time, y: [push.force, slow]}").recordings ==
        std::vector<std::size_t>{0, 1});
  CHECK_THAT(faults_of("{plot: xy, x: rig.x, y: slow}"),
             Catch::Contains("'rig.x' and 'slow' are recorded at different periods"));
  CHECK_THAT(faults_of("{plot: lines, x: time, y: push.force + slow}"),
             Catch::Contains("'push.force' and 'slow' are recorded at different periods"));
}

TEST_CASE("every plot explains its keys") {
  for (const auto& plot : plot_forms(true)) {
    INFO(plot.name);
    CHECK_FALSE(plot.doc.empty());
    CHECK_FALSE(plot.of.empty());
    for (const auto& key : plot.of) CHECK_FALSE(key.doc.empty());
  }
}

}  // namespace stepwire::plot
