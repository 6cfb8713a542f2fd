
#include "engine/view/render/scene_drawing.hpp"
#include "tests/engine/view/plot/frozen_animation.hpp"
#include "tests/engine/view/plot/scene_samples.hpp"

namespace stepwire::render {
using namespace testing;
using Catch::Contains;

namespace {

std::string still_of(const scene::Scene& scene, const record::Recording& recording, std::size_t row) {
  svg::SvgElement sheet = scene_sheet(scene, scene_width, scene_height(scene), "Pen");
  sheet.add(scene_frame(scene, scene::view_of(scene, recording).shapes(scene::row_of(recording, row))));
  return svg::svg_text(sheet);
}

}  // namespace

TEST_CASE("at the instant of each of its frames an animation shows what a still shows") {
  const scene::Scene scene = scene_of(all_objects);
  const record::Recording recording = pen_recording(40);
  const std::string animation = animated_scene(scene, "d.yaml", std::vector{recording}, "Pen");
  const AnimationRows rows = animation_rows(scene, "d.yaml", recording, 600);
  REQUIRE(rows.rows.size() == 21);  // 40 steps of 25 ms, at 20 frames per second
  CHECK(rows.seconds == Approx(1.0));
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    INFO("frame " << i);
    seen.push_back(frozen(animation, static_cast<double>(i) / 20.0));
    CHECK(seen.back() == still_of(scene, recording, rows.rows[i]));
    CHECK((i == 0 || seen[i] != seen[i - 1]));
  }
}

TEST_CASE("an animation begins, ends and goes as the file says, through the run that it says") {
  const record::Recording recording = pen_recording(100);
  const scene::Scene scene =
      scene_of("a: {ball: pen}", ", animation: {from: 200 ms, to: 600 ms, speed: 0.5, where: run == 1}");
  const AnimationRows rows = animation_rows(scene, "d.yaml", recording, 600);
  CHECK(rows.seconds == Approx(0.78));
  CHECK(rows.rows.front() == 101 + 21);
  CHECK(rows.rows.back() == 101 + 60);
  CHECK(rows.rows[1] - rows.rows[0] == 3);  // 10 ms of the run last 20 ms: 60 ms between frames
}

TEST_CASE("a long recording has no more frames than are wanted") {
  const scene::Scene scene = scene_of("a: {ball: pen}", ", animation: {speed: 0.001}");
  const record::Recording recording = pen_recording(5000);
  CHECK(animation_rows(scene, "d.yaml", recording, 600).rows.size() <= 600);
  CHECK(animation_rows(scene, "d.yaml", recording, 3).rows.size() <= 3);
}

TEST_CASE("an animation stays below its largest size") {
  std::string many = all_objects;
  for (int i = 0; i < 30; ++i) many += ", ball" + std::to_string(i) + ": {ball: [pen.1, 0.1*pen.1 + 0.1 mm]}";
  const scene::Scene scene = scene_of(many, ", animation: {speed: 0.01}");
  const std::string animation = animated_scene(scene, "d.yaml", std::vector{pen_recording(5000)}, "Pen");
  CHECK(animation.size() <= largest_animation);
  CHECK(animation.size() > largest_animation / 3);
}

TEST_CASE("where no row is left, an animation says so") {
  const std::vector recordings{pen_recording(10)};
  const scene::Scene none = scene_of("a: {ball: pen}", ", animation: {where: run == 2}");
  CHECK_THROWS_WITH(animated_scene(none, "d.yaml", recordings, ""),
                    Contains("d.yaml:1:1: scene.animation: no row is left to be drawn"));
  const scene::Scene one = scene_of("a: {ball: pen}", ", animation: {from: 990 ms}");
  CHECK_THROWS_WITH(animated_scene(one, "d.yaml", recordings, ""), Contains("fewer than two rows"));
}

}  // namespace stepwire::render
