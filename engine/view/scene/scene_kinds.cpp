#include "engine/view/scene/scene.hpp"

namespace stepwire::scene {

const std::vector<SceneKind>& scene_kinds() {
  constexpr std::size_t any_number = 1000;
  static const std::vector<SceneKind> kinds{
      {"ball", "a ball about a point", 1, 1, "yellow"},
      {"rod", "a rod from a point to another", 2, 2, "grey"},
      {"walls", "the boundary of a block, such as a Region, by its name; each closed line is a wall", 0, 0,
       "blue"},
      {"circle", "a line around a point, its centre", 1, 1, "white"},
      {"line", "a line through points", 2, any_number, "green"},
      {"point", "a spot", 1, 1, "blue"},
      {"text", "words, for whoever looks at the scene", 0, 0, "white"},
  };
  return kinds;
}

const std::vector<SceneColor>& scene_colors() {
  static const std::vector<SceneColor> colors{
      {"blue", "#2f80ff"},   {"red", "#ff3b30"},    {"green", "#30d158"}, {"yellow", "#ffcc00"},
      {"orange", "#ff9f0a"}, {"purple", "#bf5af2"}, {"cyan", "#3fc8e4"},  {"grey", "#98a2ad"},
      {"white", "#f5f7fa"},  {"black", "#11161c"}};
  return colors;
}

}  // namespace stepwire::scene
