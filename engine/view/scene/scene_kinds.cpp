#include "engine/view/scene/scene.hpp"

namespace stepwire {

const std::vector<SceneKind>& scene_kinds() {
  constexpr std::size_t any_number = 1000;
  static const std::vector<SceneKind> kinds{
      {"ball", "a ball about a point", 1, 1, "yellow", {"radius"}},
      {"rod", "a rod from a point to another", 2, 2, "grey", {"width"}},
      {"walls",
       "the boundary of a block, such as a Region, by its name; each closed line is a wall",
       0,
       0,
       "blue",
       {"crossed", "distance", "nearest", "width"}},
      {"circle", "a line around a point, its centre", 1, 1, "white", {"radius", "width"}},
      {"line", "a line through points", 2, any_number, "green", {"width"}},
      {"point", "a spot", 1, 1, "blue", {"radius"}},
      {"text", "words, for whoever looks at the scene", 0, 0, "white", {"at", "size"}},
  };
  return kinds;
}

const std::vector<SceneKey>& scene_object_keys() {
  static const std::vector<SceneKey> keys{
      {"color",
       "a colour, or colours by condition, of which the first that holds counts: {red: map.distance > 0, "
       "else: "
       "blue}"},
      {"when", "the object is shown while this expression is true"},
      {"radius", "of a ball, circle or point"},
      {"width", "of the line, or of the rod"},
      {"crossed",
       "colour of the wall that is crossed: that at the nearest boundary point, while the distance is above "
       "0"},
      {"distance",
       "from the boundary; without it the output distance of the block itself, which is recorded"},
      {"nearest", "point of the boundary; without it the block's output nearest, which is recorded"},
      {"at", "where the middle of the text is: [x, y]"},
      {"size", "height of the letters"}};
  return keys;
}

const std::vector<SceneKey>& scene_animation_keys() {
  static const std::vector<SceneKey> keys{
      {"from", "time in the run at which it begins"},
      {"to", "time in the run at which it ends"},
      {"speed", "seconds of the run in one second of the animation (1)"},
      {"where", "of several runs, that with the first row for which this is true; without it the first"}};
  return keys;
}

const std::vector<SceneColor>& scene_colors() {
  static const std::vector<SceneColor> colors{
      {"blue", "#2f80ff"},   {"red", "#ff3b30"},    {"green", "#30d158"}, {"yellow", "#ffcc00"},
      {"orange", "#ff9f0a"}, {"purple", "#bf5af2"}, {"cyan", "#3fc8e4"},  {"grey", "#98a2ad"},
      {"white", "#f5f7fa"},  {"black", "#11161c"}};
  return colors;
}

}  // namespace stepwire
