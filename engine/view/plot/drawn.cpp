#include "engine/view/plot/drawn.hpp"

#include <fmt/format.h>

namespace stepwire::plot {
namespace {

/// The name with a number behind it, and also without where that is 1.
std::vector<std::string> numbered_names(const std::vector<std::string>& names, std::size_t number) {
  std::vector<std::string> result;
  for (const std::string& name : names) result.push_back(fmt::format("{}.{}", name, number));
  if (number == 1) result.insert(result.end(), names.begin(), names.end());
  return result;
}

void add(const std::vector<std::string>& places, const std::string& name, const query::Formula& formula,
         std::vector<query::NamedFormula>& drawn) {
  for (const std::string& place : places) drawn.push_back({fmt::format("{}.{}", place, name), formula.text});
}

/// What is drawn over the panel: "figure.motion.x", "figure.rose.2.value".
void add_overlays(const Panel& panel, const std::vector<std::string>& places,
                  std::vector<query::NamedFormula>& drawn) {
  for (std::size_t i = 0; i < panel.motions.size(); ++i)
    for (const std::string& name : numbered_names({"motion"}, i + 1)) {
      const Motion& motion = panel.motions[i];
      add(places, name + ".x", motion.x.formula, drawn);
      add(places, name + ".y", motion.y.formula, drawn);
      if (motion.where) add(places, name + ".where", *motion.where, drawn);
    }
  for (std::size_t i = 0; i < panel.roses.size(); ++i)
    for (const std::string& name : numbered_names({"rose"}, i + 1)) {
      const Rose& rose = panel.roses[i];
      add(places, name + ".x", rose.x.formula, drawn);
      add(places, name + ".y", rose.y.formula, drawn);
      add(places, name + ".angle", rose.angle.formula, drawn);
      add(places, name + ".value", rose.value.formula, drawn);
      if (rose.where) add(places, name + ".where", *rose.where, drawn);
    }
}

void add_quantities(const Panel& panel, const std::vector<std::string>& places,
                    std::vector<query::NamedFormula>& drawn) {
  for (const std::string& place : places) {
    if (panel.where) drawn.push_back({place + ".where", panel.where->text});
    for (const auto& [key, list] : panel.series)
      for (std::size_t i = 0; i < list.size(); ++i)
        for (const std::string& name : numbered_names({fmt::format("{}.{}", place, key)}, i + 1))
          drawn.push_back({name, list[i].formula.text});
  }
}

void add_places(const scene::SceneObject& object, const scene::Scene& scene,
                std::vector<query::NamedFormula>& shown) {
  for (std::size_t point = 0; point < object.points.size(); ++point)
    for (const std::string& name : numbered_names({"scene." + object.name}, point + 1))
      for (const std::size_t axis : {0u, 1u})
        shown.push_back({name + (axis == 0 ? ".x" : ".y"), scene.formulas[object.points[point][axis]].text});
}

}  // namespace

std::vector<query::NamedFormula> drawn_quantities(const std::vector<Figure>& figures) {
  std::vector<query::NamedFormula> drawn;
  for (std::size_t picture = 0; picture < figures.size(); ++picture)
    for (std::size_t panel = 0; panel < figures[picture].panels.size(); ++panel) {
      // a panel's number stands only behind that of its picture
      std::vector<std::string> places = numbered_names({fmt::format("figure.{}", picture + 1)}, panel + 1);
      if (picture == 0 && panel == 0) places.emplace_back("figure");
      add_quantities(figures[picture].panels[panel], places, drawn);
      add_overlays(figures[picture].panels[panel], places, drawn);
    }
  return drawn;
}

std::vector<query::NamedFormula> shown_quantities(const scene::Scene& scene) {
  std::vector<query::NamedFormula> shown;
  for (const scene::SceneObject& object : scene.objects) {
    add_places(object, scene, shown);
    if (object.radius)
      shown.push_back({fmt::format("scene.{}.radius", object.name), scene.formulas[*object.radius].text});
  }
  return shown;
}

}  // namespace stepwire::plot
