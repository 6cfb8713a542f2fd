#include "engine/app/reference/schema_scene.hpp"

#include "engine/app/reference/schema_values.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire {

namespace {

/// [x, y], or the name of a recorded vector.
Json point() {
  return any_of(
      {schema_ref("text"), list_of(schema_ref("expression")).set("minItems", 2).set("maxItems", 2)});
}

Json color() {
  Json names = Json::list();
  for (const SceneColor& named : scene_colors()) names.push(constant(named.name, named.value));
  Json choice = Json::object().set("anyOf", std::move(names));
  return any_of({std::move(choice), typed("string").set("pattern", "^#[0-9A-Fa-f]{6}$")});
}

/// A colour, or for several a condition each.
Json colors() {
  Json rules = Json::object().set("type", "object").set("additionalProperties", schema_ref("expression"));
  return any_of({color(), std::move(rules)});
}

/// What stands under the name of a kind.
Json value_of(const SceneKind& kind) {
  if (kind.most_points == 0) return schema_ref("text");
  if (kind.most_points == 1) return point();
  Json points = list_of(point()).set("minItems", kind.least_points);
  return points.set("maxItems", kind.most_points);
}

Json value_of(const std::string& key) {
  if (key == "color") return colors();
  if (key == "crossed") return color();
  if (key == "at" || key == "nearest") return point();
  return schema_ref("expression");
}

Json object_schema() {
  Json keys = Json::object(), choices = Json::list();
  for (const SceneKind& kind : scene_kinds()) {
    keys.set(kind.name, explained(value_of(kind), kind.doc));
    choices.push(Json::object().set("required", Json::list({kind.name})));
  }
  for (const SceneKey& key : scene_object_keys()) keys.set(key.name, explained(value_of(key.name), key.doc));
  return closed_map(std::move(keys)).set("oneOf", std::move(choices));
}

Json view_schema() {
  Json range = pair_of(schema_ref("number"));
  Json keys = Json::object().set("x", explained(range, "to the right: [-20 mm, 20 mm]"));
  keys.set("y", explained(range, "upward"));
  return explained(closed_map(std::move(keys), {"x", "y"}), "what is seen of the plane");
}

Json animation_schema() {
  Json keys = Json::object();
  for (const SceneKey& key : scene_animation_keys())
    keys.set(key.name, explained(schema_ref("expression"), key.doc));
  return explained(closed_map(std::move(keys)), "what of the run scene.svg shows; without it the whole run");
}

}  // namespace

Json scene_schema() {
  Json objects = Json::object().set("type", "object").set("minProperties", 1);
  Json keys = Json::object().set("view", view_schema());
  keys.set("objects",
           explained(objects.set("additionalProperties", object_schema()),
                     "by name, in the order in which they are drawn: {hand: {ball: rig.position}}"));
  keys.set("background",
           explained(any_of({one_word_of({"dark", "light"}), color()}), "dark where it is not given"));
  keys.set("animation", animation_schema());
  return explained(
      closed_map(std::move(keys), {"view", "objects"}),
      "objects that follow signals, as somebody at the device sees them: an animation, and `plot: scene`");
}

}  // namespace stepwire
