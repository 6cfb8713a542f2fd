#include "engine/view/plot/drawn.hpp"

#include <catch2/catch.hpp>

#include "tests/engine/view/plot/scene_samples.hpp"

namespace stepwire::plot {
using namespace testing;

namespace {

/// What stands for a name; empty where there is no such name.
std::string text_of(const std::vector<query::NamedFormula>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &query::NamedFormula::name);
  return found == all.end() ? "" : found->text;
}

}  // namespace

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
  CHECK(text_of(drawn_quantities(figures), "figure.where") == "pen.1 > 1 mm");
}

}  // namespace stepwire::plot
