#include <algorithm>

#include "engine/view/render/render.hpp"
#include "engine/view/render/scene_drawing.hpp"
#include "engine/view/scene/scene_states.hpp"
#include "tests/engine/view/plot/scene_samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

/// The figures of a text over a scene.
ReadFigures figures_over(const scene::Scene& scene, const std::string& text) {
  query::SymbolTable names = pen_names();
  names.scene = std::make_shared<const scene::Scene>(scene);
  const yaml::Document document = yaml::parse_document(text, "d.yaml");
  yaml::Faults faults;
  auto figures = read_figures(document.root, names, faults);
  return {std::move(figures), all_text(faults)};
}

std::string drawn(const scene::Scene& scene, const std::string& text) {
  const ReadFigures read = figures_over(scene, text);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return render::draw(read.figures.at(0), std::vector{pen_recording(1000)}).svg;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("a point of the scene stands in the picture to scale, with y upward") {
  // 10 mm are 480 pixels: (1, 2) mm is 6 mm from the left and 2 mm from the upper edge.
  const std::string svg = drawn(scene_of("a: {ball: [1 mm, 2 mm], radius: 0.5 mm}"), "{plot: scene}");
  CHECK_THAT(svg, Contains("<circle cx=\"288\" cy=\"96\" r=\"24\" fill=\"#ffcc00\""));
}

TEST_CASE("a scene is drawn at the instants that a figure names, side by side") {
  const scene::Scene scene = scene_of("a: {ball: pen, radius: 0.5 mm}");
  const std::string svg =
      drawn(scene, "{plot: scene, at: [0.25 s, 750 ms], words: [first, second], title: A pen}");
  CHECK_THAT(svg, Contains("<circle cx=\"288\" cy=\"192\"") && Contains("<circle cx=\"384\" cy=\"192\""));
  CHECK_THAT(svg, Contains(">first, 0.25 s<") && Contains(">second, 0.75 s<") && Contains(">A pen</text>"));
  CHECK(count_of(svg, "url(#ground)") == 2);
}

TEST_CASE("without an instant the first row is drawn for which `where` is true") {
  const scene::Scene scene = scene_of("a: {ball: pen, radius: 0.5 mm}");
  CHECK_THAT(drawn(scene, "{plot: scene, where: pen.1 >= 2 mm && run == 1}"),
             Contains("<circle cx=\"336\" cy=\"144\""));
  CHECK_THAT(drawn(scene, "{plot: scene, where: run == 1, at: 0.5 s}"),
             Contains("<circle cx=\"336\" cy=\"144\""));
}

TEST_CASE("a plot of a scene is refused where there is none, and for what it does not know") {
  CHECK_THAT(figures_of("{plot: scene}").faults,
             Contains("figure.plot: a plot 'scene' draws the section 'scene'"));
  const scene::Scene scene = scene_of("a: {ball: pen}");
  CHECK_THAT(figures_over(scene, "{plot: scene, at: 1 m}").faults, Contains("figure.at: 1 m is in m"));
  CHECK_THAT(figures_over(scene, "{plot: scene, at: -1 s}").faults,
             Contains("figure.at: -1 s is not within the run"));
  CHECK_THAT(figures_over(scene, "{plot: scene, words: [a, b]}").faults,
             Contains("there are 2 texts for 1 instant"));
  CHECK_THAT(figures_over(scene, "{plot: scene, att: 1 s}").faults, Contains("did you mean 'at'?"));
  CHECK_THAT(figures_over(scene, "{plot: scene, where: slow > 1 N}").faults,
             Contains("recorded at different periods"));
}

TEST_CASE("what is hidden is not seen, and words are escaped") {
  const scene::Scene scene = scene_of("a: {text: \"1 < 2\", at: [0, 0], when: pen.1 > 2 mm}");
  CHECK_THAT(drawn(scene, "{plot: scene, at: 0 s}"), Contains("visibility=\"hidden\">1 &lt; 2</text>"));
  CHECK_THAT(drawn(scene, "{plot: scene, at: 1 s}"), Contains("visibility=\"visible\">1 &lt; 2</text>"));
}

TEST_CASE("what a scene shows stands in columns, for claims") {
  const scene::Scene scene = scene_of(all_objects);
  std::vector<std::string> names;
  for (const query::RecordedName& name : scene::scene_state_names(scene)) names.push_back(name.name);
  CHECK(names == std::vector<std::string>{"scene.walls.1.blue", "scene.walls.1.red", "scene.walls.2.blue",
                                          "scene.walls.2.red", "scene.way.shown", "scene.goal.shown",
                                          "scene.ball.red", "scene.ball.yellow", "scene.hint.shown"});
  std::vector recordings{pen_recording(400)};
  scene::add_scene_states(scene, recordings);
  const table::Table& table = recordings[0].table;
  const auto value = [&](const std::string& name, std::size_t row) {
    return table.find(name)->values.at(row);
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double x = value("pen.1", row);  // of a square from 1 to 2 mm
    if (std::min(std::abs(x - 1e-3), std::abs(x - 2e-3)) < 1e-9) continue;
    INFO("x = " << x);
    CHECK(value("scene.walls.1.red", row) == (x > 2e-3));
    CHECK(value("scene.walls.2.red", row) == (x < 1e-3));
    CHECK(value("scene.walls.2.blue", row) == !(x < 1e-3));
    CHECK(value("scene.ball.red", row) == (x < 1e-3 || x > 2e-3));
    CHECK(value("scene.way.shown", row) == (x < 1e-3 || x > 2e-3));
  }
}

TEST_CASE("a sentence at the edge of a scene is not cut off, and a long one is smaller") {
  // An m of DejaVu Sans, the widest usual font, is 0.974 of its size wide; the picture is 480 wide.
  const auto reaches = [](const std::string& words) {
    const scene::Scene scene = scene_of("a: {text: " + words + ", at: [3.9 mm, 1 mm], size: 0.6 mm}");
    record::Recording recording = pen_recording(10);
    const scene::SceneView view = scene::view_of(scene, recording);
    const svg::SvgElement frame = render::scene_frame(scene, view.shapes(scene::row_of(recording, 0)));
    const svg::SvgElement& text = frame.children.back();
    const auto number = [&](const std::string& name) {
      for (const svg::SvgAttribute& attribute : text.attributes)
        if (attribute.name == name) return std::stod(attribute.value);
      return 0.0;
    };
    const double half = 0.5 * 0.974 * number("font-size") * static_cast<double>(words.size());
    CHECK(number("x") + half <= 480.0);
    CHECK(number("x") - half >= 0.0);
    return number("font-size");
  };
  const double usual = reaches("mmmm"), small = reaches(std::string(40, 'm'));
  CHECK(usual == Approx(480.0 * 0.6 / 10.0));
  CHECK(small < 0.6 * usual);
}

}  // namespace stepwire::plot
