#include "tests/engine/view/plot/scene_samples.hpp"

namespace stepwire::scene {
using namespace testing;

namespace {

const std::vector<std::string> columns{"map.nearest.2", "pen.2", "pen.1", "map.distance", "map.nearest.1"};

/// The shapes while the pen is at (x, y), so far from the boundary, with (x, y) of its nearest point in mm.
std::vector<SceneShape> at(const Scene& scene, double x, double y, double distance, double near_x,
                           double near_y) {
  const std::vector<double> row{1e-3 * near_y, 1e-3 * y, 1e-3 * x, 1e-3 * distance, 1e-3 * near_x};
  return SceneView(scene, columns).shapes(row);
}

}  // namespace

TEST_CASE("objects follow their signals, whatever the order of the columns") {
  const Scene scene =
      scene_of("rod: {rod: [[1 mm, 2 mm], pen]}, ball: {ball: [2*pen.1, pen.2 + 1 mm], radius: $reach}");
  const auto shapes = at(scene, 3.0, -1.0, 0.0, 0.0, 0.0);
  REQUIRE(shapes.size() == 2);
  CHECK(shapes[0].points[0] == std::array{1e-3, 2e-3});
  CHECK(shapes[0].points[1] == std::array{3e-3, -1e-3});
  CHECK(shapes[1].points[0][0] == Approx(6e-3));
  CHECK(shapes[1].points[0][1] == Approx(0.0).margin(1e-18));
  CHECK(shapes[1].size == 3e-3);
}

TEST_CASE("the first colour whose condition holds is taken, or the last") {
  const Scene scene = scene_of(
      "a: {ball: pen, color: {else: blue, red: pen.1 > 2 mm, \"#00ff00\": pen.1 > 1 mm}}, "
      "b: {ball: pen, color: {red: pen.1 > 1 mm}}, c: {point: pen, color: cyan}");
  const auto color = [&](double x, std::size_t i) { return at(scene, x, 0.0, 0.0, 0.0, 0.0)[i].color; };
  CHECK(color(2.5, 0).name == "red");
  CHECK(color(1.5, 0).value == "#00ff00");
  CHECK(color(0.5, 0).name == "blue");
  CHECK(color(0.5, 1).name == "yellow");
  CHECK(color(2.5, 2).name == "cyan");
}

TEST_CASE("only the wall that is crossed changes its colour, the one at the nearest boundary point") {
  const Scene scene = scene_of("walls: {walls: map, color: blue, crossed: red}");
  const auto colors = [&](double distance, double near_x, double near_y) {
    const auto shapes = at(scene, 0.0, 0.0, distance, near_x, near_y);
    REQUIRE(shapes.size() == 2);
    return shapes[0].color.name + " " + shapes[1].color.name;
  };
  CHECK(colors(-0.1, 2.0, 0.0) == "blue blue");
  CHECK(colors(0.0, 2.0, 0.0) == "blue blue");
  CHECK(colors(0.1, 2.0, 0.3) == "red blue");
  CHECK(colors(0.1, -0.4, -1.0) == "blue red");
  CHECK(colors(0.1, -1.0, 0.9) == "blue red");  // on the side that closes the line
}

TEST_CASE("what has no place is hidden, and so is what its condition hides") {
  const Scene scene =
      scene_of("a: {ball: pen, when: map.distance > 0}, b: {line: [[0, 0], [sqrt(pen.1/(1 m)), 0]]}");
  const auto shown = [&](double x, double distance) {
    const auto shapes = at(scene, x, 0.0, distance, 0.0, 0.0);
    return std::pair(shapes[0].shown, shapes[1].shown);
  };
  CHECK(shown(1.0, 1.0) == std::pair(true, true));
  CHECK(shown(-1.0, 1.0) == std::pair(true, false));
  CHECK(shown(1.0, 0.0) == std::pair(false, true));
}

TEST_CASE("a row without a signal of the scene is refused") {
  const Scene scene = scene_of("a: {ball: pen}");
  CHECK_THROWS_WITH(SceneView(scene, {"pen.1"}), "'pen.2' was not recorded");
}

}  // namespace stepwire::scene
