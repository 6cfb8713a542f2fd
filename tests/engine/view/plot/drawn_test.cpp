#include "engine/view/plot/drawn.hpp"

#include <catch2/catch.hpp>

#include "tests/engine/view/plot/samples.hpp"
#include "tests/engine/view/plot/scene_samples.hpp"

namespace stepwire::plot {
using namespace testing;

namespace {

/// Returns the formula of a name; empty if there is no such name.
std::string text_of(const std::vector<query::NamedFormula>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &query::NamedFormula::name);
  return found == all.end() ? "" : found->text;
}

/// Returns the names of what the figures of a text draw, with a sweep of two currents.
std::vector<query::NamedFormula> drawn_in(const std::string& figures) {
  query::SymbolTable names = sample_names();
  names.columns[1].values = {0.0, 0.1};
  names.columns.push_back({"map.distance", unit::Dimension{{1}}, 0});
  yaml::Faults faults;
  const yaml::Document document = yaml::parse_document(figures, "d.yaml");
  const std::vector<Figure> read = read_figures(document.root, names, faults);
  INFO(all_text(faults));
  REQUIRE(faults.empty());
  return drawn_quantities(read, names);
}

}  // namespace

TEST_CASE("claims may name a row by its text in the legend, and a channel by the label of its axis") {
  const auto drawn = drawn_in(
      "{plot: lines, x: time, y: [rig.x, 2*rig.x], legend: [reached, as wanted (2)], y_label: path}");
  CHECK(text_of(drawn, "figure.y.as_wanted_2") == "2*rig.x");
  CHECK(text_of(drawn, "figure.1.1.path.reached") == "rig.x");
  CHECK(text_of(drawn, "figure.path.2") == "2*rig.x");
  CHECK(text_of(drawn, "figure.x.as_wanted_2") == "time");
}

TEST_CASE("a text in the legend that is also a number or a key does not take its name") {
  const auto drawn =
      drawn_in("{plot: lines, x: time, y: [rig.x, 2*rig.x], legend: ['2', '1'], x_label: y, y_label: x}");
  CHECK(text_of(drawn, "figure.y.1") == "rig.x");
  CHECK(text_of(drawn, "figure.y") == "rig.x");
}

TEST_CASE("claims may name a picture and a panel by its title") {
  const auto drawn = drawn_in(
      "[{plot: lines, title: Way over time, x: time, y: rig.x}, "
      "{title: Both, panels: [{plot: lines, title: left damper, x: time, y: 2*rig.x}, "
      "{plot: lines, title: 1, x: time, y: 3*rig.x}]}]");
  CHECK(text_of(drawn, "figure.Way_over_time.y") == "rig.x");
  CHECK(text_of(drawn, "figure.2.left_damper.y") == "2*rig.x");
  CHECK(text_of(drawn, "figure.Both.left_damper.y.1") == "2*rig.x");
  CHECK(text_of(drawn, "figure.Both.2.y") == "3*rig.x");
  CHECK(text_of(drawn, "figure.2.1.y") == "2*rig.x");  // the number of a panel, not its title
}

TEST_CASE("claims may name the curve of a swept value by its text in the legend") {
  const auto drawn = drawn_in("{plot: loop, x: rig.x, y: rig.v, by: current, legend: [off, 0.1 A]}");
  CHECK(text_of(drawn, "figure.by.off") == "current == 0 A");
  CHECK(text_of(drawn, "figure.by.0_1_A") == "current == 0.1 A");
  CHECK(text_of(drawn, "figure.y.off").empty());
}

TEST_CASE("claims may name what is drawn over a plane") {
  const auto drawn = drawn_in(
      "{plot: xy, x: rig.x in mm, y: 2*rig.x in mm, region: map, boundary: x - 5 mm + y, "
      "marks: {A: [1 mm, 2 mm]}, texts: {free region: [3 mm, 4 mm]}}");
  CHECK(text_of(drawn, "figure.region.distance") == "map.distance");
  CHECK(text_of(drawn, "figure.boundary") == "(rig.x) - 5 mm + (2*rig.x)");
  CHECK(text_of(drawn, "figure.marks.A.y") == "0.002 m");
  CHECK(text_of(drawn, "figure.texts.free_region.x") == "0.003 m");
}

TEST_CASE("claims may name the cells of a table, and the labelled signals of a picture of the diagram") {
  const auto drawn = drawn_in(
      "[{plot: table, headings: [of, the way, ẋ], rows: {thesis: [$reach in mm, rig.v]}}, "
      "{plot: diagram, labels: {push.force: F_d}}]");
  CHECK(text_of(drawn, "figure.thesis.the_way") == "$reach");
  CHECK(text_of(drawn, "figure.1.thesis.2") == "rig.v");
  CHECK(text_of(drawn, "figure.2.labels.F_d") == "push.force");
}

TEST_CASE("claims may name the points and the direction of an element of a rig") {
  const auto drawn = drawn_in(
      "{plot: rig, points: {pin: [rig.x, 2 mm]}, elements: ["
      "{damper: [[-10 mm, 0 mm], pin], name: left damper}, {force: pin, direction: [1, 0], name: F_e}]}");
  CHECK(text_of(drawn, "figure.elements.left_damper.x") == "-10 mm");
  CHECK(text_of(drawn, "figure.1.elements.left_damper.2.x") == "rig.x");
  CHECK(text_of(drawn, "figure.elements.F_e.direction.x") == "1");
}

TEST_CASE("claims may name where the objects of a scene are") {
  const std::vector<query::NamedFormula> shown = shown_quantities(scene_of(all_objects));
  CHECK(text_of(shown, "scene.ball.x") == "pen.1");
  CHECK(text_of(shown, "scene.ball.y") == "pen.2");
  CHECK(text_of(shown, "scene.way.x") == "pen.1");
  CHECK(text_of(shown, "scene.way.2.y") == "map.nearest.2");
  CHECK(text_of(shown, "scene.bow.3.x") == "1 mm");
  CHECK(text_of(shown, "scene.ring.radius") == "$reach");
  CHECK(text_of(shown, "scene.walls.x").empty());
}

TEST_CASE("claims may name the condition under which an instant of a scene is drawn") {
  query::SymbolTable names = pen_names();
  names.scene = std::make_shared<const scene::Scene>(scene_of(all_objects));
  yaml::Faults faults;
  const yaml::Document document = yaml::parse_document("{plot: scene, where: pen.1 > 1 mm}", "d.yaml");
  const std::vector<Figure> figures = read_figures(document.root, names, faults);
  CHECK(all_text(faults).empty());
  CHECK(text_of(drawn_quantities(figures, names), "figure.where") == "pen.1 > 1 mm");
}

}  // namespace stepwire::plot
