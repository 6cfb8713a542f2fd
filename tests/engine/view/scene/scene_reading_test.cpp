#include "tests/engine/view/plot/scene_samples.hpp"

namespace stepwire::scene {
using namespace testing;
using Catch::Contains;

TEST_CASE("a scene has its objects in the order of the file, with lengths in metres") {
  const Scene scene =
      scene_of(all_objects, ", background: light, animation: {from: 200 ms, to: 0.8 s, speed: 2}");
  CHECK(scene.x == std::array{-5e-3, 5e-3});
  CHECK(scene.y == std::array{-4e-3, 4e-3});
  REQUIRE(scene.objects.size() == 8);
  CHECK(scene.objects[0].walls.size() == 2);
  CHECK(scene.objects[0].crossed->name == "red");
  CHECK(scene.objects[3].kind->name == "line");
  CHECK(scene.objects[7].text == "a < b");
  CHECK(scene.background == "light");
  CHECK(scene.animation.from == 0.2);
  CHECK(scene.animation.to == 0.8);
  CHECK(scene.animation.speed == 2.0);
  CHECK(scene.recording == 0);
}

TEST_CASE("a scene without a view or without objects says what is missing") {
  CHECK_THAT(
      read_scene_of("{objects: {a: {ball: pen}}}").faults,
      Contains(
          "d.yaml:1:1: scene: 'view' is missing (what is seen of the plane); view: {x: [-5 mm, 5 mm], y:"));
  CHECK_THAT(read_scene_of("{view: {x: [2 mm, 1 mm], y: [1 N, 2 N], z: 1}}").faults,
             Contains("d.yaml:1:12: scene.view.x: the first number of a range is below the second") &&
                 Contains("d.yaml:1:30: scene.view.y: 1 N is in N, but a length is in m") &&
                 Contains("a view has no 'z'") && Contains("scene: 'objects' is missing (by name"));
  CHECK_THAT(read_scene_of("[a]").faults, Contains("scene: a scene is a map"));
}

TEST_CASE(
    "an object that is none, a key that it has not, and a colour that is none are told with the nearest") {
  CHECK_THAT(scene_faults("a: {bal: pen}"),
             Contains("scene.a: an object has no 'bal'; did you mean 'ball'?"));
  CHECK_THAT(scene_faults("a: {color: red}"),
             Contains("scene.a: an object needs one kind: ball, rod, walls"));
  CHECK_THAT(scene_faults("a: {ball: pen, width: 1 mm}"),
             Contains("scene.a.width: 'width' goes with 'rod', 'walls', 'circle', 'line' only"));
  CHECK_THAT(scene_faults("a: {ball: pen, colour: red}"), Contains("did you mean 'color'?"));
  CHECK_THAT(
      scene_faults("a: {ball: pen, color: bleu}"),
      Contains("scene.a.color: there is no colour 'bleu'; did you mean 'blue'?") && Contains("\"#rrggbb\""));
  CHECK_THAT(scene_faults("a: {ball: pen, color: {rde: time > 1 s}}"), Contains("did you mean 'red'?"));
  CHECK_THAT(scene_faults("a: {ball: pen}", ", background: drak"), Contains("did you mean 'dark'?"));
  CHECK_THAT(scene_faults("a: {ball: pen}", ", animation: {sped: 2}"), Contains("did you mean 'speed'?"));
}

TEST_CASE("units of a scene are those of lengths, and conditions fit theirs") {
  CHECK_THAT(scene_faults("a: {ball: [push, 0]}"),
             Contains("d.yaml:1:67: scene.a.ball: 'push' is in N, but a length"));
  CHECK_THAT(scene_faults("a: {ball: pen, radius: 2 s}"), Contains("scene.a.radius: '2 s' is in s"));
  CHECK_THAT(scene_faults("a: {ball: pen, when: map.distance > 0 N}"), Contains("scene.a.when: "));
  CHECK_THAT(scene_faults("a: {ball: pen}", ", animation: {from: 1 m}"), Contains("but a time is in s"));
  CHECK_THAT(scene_faults("a: {ball: pen}", ", animation: {from: 2 s, to: 1 s}"),
             Contains("behind its beginning"));
  CHECK_THAT(scene_faults("a: {ball: pen}", ", animation: {speed: 0}"), Contains("it must be above 0"));
}

TEST_CASE("points have two coordinates, and lines as many as they need") {
  CHECK_THAT(scene_faults("a: {ball: [1 mm, 2 mm, 3 mm]}"),
             Contains("a point of a scene has two coordinates, [x, y], and this has 3"));
  CHECK_THAT(scene_faults("a: {ball: map.distance}"), Contains("and this has 1"));
  CHECK_THAT(scene_faults("a: {rod: [pen]}"),
             Contains("scene.a.rod: 'rod' is a rod from a point to another"));
  CHECK_THAT(scene_faults("a: {circle: pen}"), Contains("scene.a: a circle needs a radius"));
  CHECK_THAT(scene_faults("a: {text: b}"), Contains("scene.a: a text needs a place"));
}

TEST_CASE(
    "walls are of a block with a boundary in the plane, whose distance is recorded where one turns red") {
  CHECK_THAT(scene_faults("a: {walls: mop}"),
             Contains("'mop' is no block with a boundary") && Contains("'map'"));
  CHECK_THAT(scene_faults("a: {walls: ball}"), Contains("'ball' lies in space, and a scene in the plane"));
  CHECK_THAT(scene_faults("a: {walls: hole, crossed: red}"),
             Contains("scene.a.crossed: 'hole.distance' is not recorded; add it to 'record'"));
  CHECK(scene_faults("a: {walls: hole, crossed: red, distance: map.distance, nearest: map.nearest}").empty());
}

TEST_CASE("signals of a scene are recorded together") {
  CHECK_THAT(scene_faults("a: {ball: pen, when: slow > 1 N}"),
             Contains("'pen.1' and 'slow' are recorded at different"));
}

TEST_CASE("what a scene shows has a name of its own") {
  query::SymbolTable names = pen_names();
  names.columns.push_back({"scene.a.shown", unit::Dimension{}, 0});
  yaml::Faults faults;
  const yaml::Document document = yaml::parse_document(
      "{view: {x: [0, 1], y: [0, 1]}, objects: {a: {ball: pen, when: time > 1 s}}}", "d.yaml");
  read_scene(document.root, names, faults);
  CHECK_THAT(all_text(faults), Contains("'scene.a.shown' is recorded already"));
}

}  // namespace stepwire::scene
