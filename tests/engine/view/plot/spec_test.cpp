// Specifications that each kind of plot makes from a small recording, without any renderer.
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;

namespace {

using Numbers = std::vector<double>;
using Range = std::array<double, 2>;

void check_range(const PlotAxis& axis, const Range& expected) {
  REQUIRE(axis.range);
  for (std::size_t i = 0; i < 2; ++i) CHECK((*axis.range)[i] == Approx(expected[i]).margin(1e-9));
}

void check_near(const Numbers& found, const Numbers& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-9));
}

}  // namespace

TEST_CASE(
    "lines have the numbers of the record in the units of their axes, and a colour and a text for each y") {
  const PlotSpec plot = spec_of(
      "{plot: lines, x: time in ms, y: [rig.x in mm, {signal: 2*rig.x in mm, label: twice}], title: both, "
      "y_label: way}",
      {0.0}, 4);
  CHECK((plot.x.label == "time" && plot.x.unit == "ms" && plot.y.label == "way" && plot.y.unit == "mm"));
  check_range(plot.x, {0.0, 1000.0});
  check_range(plot.y, {-2.2, 2.2});
  CHECK(plot.legend == PlotSpec::Legend::above);
  REQUIRE(plot.marks.size() == 2);
  const auto &first = mark<LineMark>(plot, 0), &second = mark<LineMark>(plot, 1);
  // the middle row is on a straight line, and left out
  check_near(first.curves.at(0).x, {0.0, 250.0, 750.0, 1000.0});
  check_near(first.curves.at(0).y, {0.0, 1.0, -1.0, 0.0});
  check_near(second.curves.at(0).y, {0.0, 2.0, -2.0, 0.0});
  CHECK((first.legend == "x of rig" && second.legend == "twice"));
  CHECK(first.line == LineStyle{"#0072B2", 2.4});
  CHECK(second.line == LineStyle{"#D55E00", 1.6});
}

TEST_CASE("a band lies below, a reference is dashed, and a shaded range keeps its ends") {
  const PlotSpec plot = spec_of(
      "{plot: lines, x: time, y: time, low: time - 1, high: time + 1, reference: 0.5*time, shade: [0.2 s, "
      "0.4 s]}",
      {0.0}, 2);
  const auto& band = mark<BandMark>(plot, 0);
  check_near(band.low, {-1.0, -0.5, 0.0});
  check_near(band.high, {1.0, 1.5, 2.0});
  CHECK(band.color == "#0072B2");
  CHECK(mark<LineMark>(plot, 2).line == LineStyle{"#0072B2", 1.4, {2.5, 4.0}});
  CHECK(mark<SpanMark>(plot, 3).low == Approx(0.2));
  CHECK(mark<SpanMark>(plot, 3).high == Approx(0.4));
  check_range(plot.y, {-1.15, 2.15});
}

TEST_CASE("few values of `by` stand in the legend, many have a colour bar") {
  const std::string text = "{plot: lines, x: time, y: push.force, by: current in mA}";
  const PlotSpec few = spec_of(text, {0.1, 0.2}, 4);
  CHECK(mark<LineMark>(few, 1).legend == "current = 200 mA");
  CHECK_FALSE(few.color);
  const PlotSpec many = spec_of(text, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}, 4);
  CHECK(many.legend == PlotSpec::Legend::none);
  REQUIRE(many.color);
  CHECK((many.color->label == "current" && many.color->unit == "mA"));
  check_range(*many.color, {100.0, 900.0});
  const auto& line = mark<LineMark>(many, 2);
  CHECK(line.line.color.empty());
  check_near(line.curves.at(0).value, Numbers(line.curves.at(0).x.size(), 300.0));
}

TEST_CASE("a loop shows where each axis is zero, and axes of one unit may be as long as each other") {
  const PlotSpec plot = spec_of("{plot: loop, x: rig.x in mm, y: rig.v in mm/s, equal: true}");
  CHECK((plot.x.zero_line && plot.y.zero_line && plot.equal));
  CHECK_FALSE(spec_of("{plot: xy, x: rig.x in mm, y: rig.v in mm/s}").x.zero_line);
}

TEST_CASE("a logarithmic axis of less than two decades names more than powers of ten, and leaves out zero") {
  const PlotSpec plot = spec_of("{plot: lines, x: time, y: time, log: y, y_range: [0.1 s, 3 s]}", {0.0}, 4);
  CHECK(plot.y.log);
  check_near(plot.y.more_ticks, {0.2, 0.5, 1.0 * 2.0});
  CHECK_FALSE(plot.y.step);
  check_near(mark<LineMark>(plot, 0).curves.at(0).y, {0.25, 0.5, 0.75, 1.0});
}

TEST_CASE("final rows have dots, one for each run") {
  const auto line =
      mark<LineMark>(spec_of("{plot: lines, x: current, y: push.force, rows: final}", {0.1, 0.2, 0.3}), 0);
  CHECK(line.dots > 0.0);
  check_near(line.curves.at(0).y, {4.0, 5.0, 6.0});
}

TEST_CASE("a path has a value at each point and the colours of its axis") {
  const PlotSpec plot = spec_of("{plot: path, x: rig.x in mm, y: time, color: push.force}", {0.1});
  REQUIRE(plot.color);
  CHECK((plot.color->label == "force of push" && plot.color->unit == "N"));
  CHECK((plot.palette.front() == ColorStop{0.0, "#3b46b3"} &&
         plot.palette.back() == ColorStop{1.0, "#b41203"}));
  const auto& line = mark<LineMark>(plot, 0);
  CHECK(line.line == LineStyle{"", 3.0});
  CHECK(geometry::extent_of(line.curves.at(0).value).high == Approx(4.0));
}

TEST_CASE("a strip is one row of cells over x, without an axis upwards") {
  const PlotSpec plot = spec_of("{plot: strip, x: time, color: time in s}");
  const auto& image = mark<ImageMark>(plot, 0);
  CHECK((image.rows == 1 && image.columns == 500 && image.values.size() == 500));
  CHECK(image.x == Approx(0.001));
  CHECK(image.values[249] == Approx(0.499));
  CHECK_FALSE(plot.y.line);
  CHECK(plot.color->step == 0.2);
}

TEST_CASE("a map of rows on a lattice has a cell for each, and lines of its levels") {
  const PlotSpec plot =
      spec_of("{plot: map, x: time, y: current, color: push.force, contour: 4.5 N}", {0.1, 0.2, 0.3}, 4);
  const auto& image = mark<ImageMark>(plot, 0);
  CHECK((image.columns == 5 && image.rows == 3 && plot.closed_frame));
  check_near(image.values, {4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6});
  check_range(plot.x, {-0.125, 1.125});
  const MarkRows& level = mark<LineMark>(plot, 1).curves.at(0);
  check_near(level.y, Numbers(level.y.size(), 0.15));
}

TEST_CASE("the longest arrow of a field is as long as a cell, and its colour is how long it was") {
  const PlotSpec plot =
      spec_of("{plot: field, x: time, y: time, u: 3*time, v: 4*time, cells: 10, pivot: tail}", {0.0}, 10);
  const auto& arrows = mark<VectorsMark>(plot, 0);
  CHECK(std::hypot(arrows.dx.back(), arrows.dy.back()) == Approx(0.1));
  CHECK(arrows.value.back() == Approx(5.0));
  CHECK(arrows.pivot == 0.0);
  CHECK(plot.color->label == "|(3*time, 4*time)|");
}

TEST_CASE("curves, points and sheets in space have three columns and a view") {
  const std::string space = "{plot: 3d, x: rig.x in mm, y: rig.v in mm/s, z: time, elevation: 30";
  const PlotSpec plot = spec_of(space + ", color: push.force}");
  REQUIRE((plot.view && plot.z));
  CHECK(*plot.view == SpaceView{30.0, 35.0});
  CHECK(plot.z->unit == "s");
  check_range(*plot.z, {-0.03, 1.03});
  CHECK(mark<LineMark>(plot, 0).curves.at(0).value.size() == mark<LineMark>(plot, 0).curves.at(0).z.size());
  CHECK(mark<PointsMark>(spec_of(space + ", style: points}"), 0).rows.z.size() == 41);
  const PlotSpec sheet = spec_of(space + ", sheets: current < 0.25}", {0.1, 0.2, 0.3}, 10);
  CHECK(mark<SurfaceMark>(sheet, 0).lines.size() == 2);
  CHECK(mark<SurfaceMark>(sheet, 0).lines.at(0).value.empty());
}

TEST_CASE("a box has the quartiles of its sample after Hazen, its median a stroke and its mean an asterisk") {
  const PlotSpec plot = spec_of("{plot: box, y: time, by: current}", {0.1, 0.2}, 4);
  const auto& boxes = mark<BoxesMark>(plot, 0);
  check_near(boxes.x, {1.0, 2.0});
  check_near(boxes.lower, {0.1875, 0.1875});
  check_near(boxes.upper, {0.8125, 0.8125});
  check_near(boxes.high_whisker, {1.0, 1.0});
  CHECK(boxes.width == 0.5);
  check_near(mark<VectorsMark>(plot, 1).y, {0.5, 0.5});
  CHECK(mark<PointsMark>(plot, 2).symbol == PointsMark::Symbol::asterisk);
  CHECK(plot.x.named_ticks == std::vector<AxisTick>{{1.0, "0.1 A"}, {2.0, "0.2 A"}});
  check_range(plot.x, {0.4, 2.6});
}

TEST_CASE("the axis of reduced values has the unit that follows from the reduction") {
  const auto unit_of = [](const std::string& x, const std::string& reduce) {
    return spec_of("{plot: histogram, x: " + x + ", reduce: " + reduce + "}", {0.0, 0.1, 0.2}, 4).x.unit;
  };
  CHECK(unit_of("rig.x in mm", "spread") == "mm");
  CHECK(unit_of("rig.x in mm", "rise_time") == "s");
  CHECK(unit_of("rig.x in mm", "iae") == "mm s");
  CHECK(unit_of("rig.x in mm", "overshoot").empty());
  CHECK(unit_of("293.15 K + rig.x*1 K/m in degC", "spread") == "K");
  CHECK(unit_of("293.15 K + rig.x*1 K/m in degC", "max") == "degC");
}

TEST_CASE("a histogram counts the values of each bin") {
  const PlotSpec plot = spec_of("{plot: histogram, x: time, bins: 2, lines: 0.5 s}", {0.0}, 4);
  const auto& bins = mark<RectanglesMark>(plot, 0);
  check_near(bins.y_high, {2.0, 3.0});
  check_near(bins.x_low, {-0.02, 0.5});
  CHECK(plot.y.label == "rows");
  check_range(plot.y, {0.0, 3.15});
  check_near(mark<LineMark>(plot, 1).curves.at(0).x, {0.5, 0.5});
}

TEST_CASE("a plot of no rows says so between axes that keep their labels") {
  const PlotSpec plot = spec_of("{plot: lines, x: time, y: rig.x in mm, where: time < 0}");
  CHECK(plot.marks.empty());
  REQUIRE(plot.texts.size() == 1);
  CHECK(plot.texts[0].text == "'time < 0' selects no rows");
  CHECK(plot.y.unit == "mm");
}

TEST_CASE("panels stand in rows of so many columns, as high as the picture leaves them") {
  const std::string line = "{plot: lines, x: time, y: rig.x}";
  const FigureSpec figure = figure_spec_of("{title: all, size: [600, 434], columns: 2, panels: [" + line +
                                           ", " + line + ", " + line + "]}");
  REQUIRE(figure.panels.size() == 3);
  CHECK((figure.width == 600.0 && figure.height == 434.0 && figure.title == "all"));
  const PanelSpec &second = figure.panels[1], &third = figure.panels[2];
  CHECK((second.left == 300.0 && second.top == 34.0 && second.width == 300.0 && second.height == 200.0));
  CHECK((third.left == 0.0 && third.top == 234.0));
  CHECK_FALSE(figure.aligned);
  CHECK(figure_spec_of("{panels: [" + line + ", " + line + "], columns: 1}").aligned);
}

TEST_CASE("a table is a panel with its texts") {
  const FigureSpec figure = figure_spec_of("{plot: table, headings: [of, found], rows: {end: time in ms}}");
  const auto& table = std::get<text::TextTable>(figure.panels.at(0).content);
  CHECK(table.columns == std::vector<std::string>{"of", "found"});
  CHECK(table.rows.at(0) == std::vector<std::string>{"end", "0 ms"});
}

}  // namespace stepwire::plot
