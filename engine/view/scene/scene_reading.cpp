#include <fmt/format.h>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/scene/scene.hpp"
#include "engine/view/scene/scene_object_reading.hpp"
#include "engine/view/scene/scene_pointer.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::scene {

using yaml::form;

namespace {

using SceneTable = yaml::KeyTable<Scene, query::NamesReading>;
using AnimationTable = yaml::KeyTable<SceneAnimation, query::NamesReading>;

const SceneTable& view_table() {
  const yaml::Key range = yaml::needed(yaml::like("[-5 mm, 5 mm]", form::pair(form::computed("m"))));
  static const SceneTable table(
      "a view", "{x: [-5 mm, 5 mm], y: [-5 mm, 5 mm]}",
      {{"x", "to the right: [-20 mm, 20 mm]", range, &Scene::x}, {"y", "upward", range, &Scene::y}});
  return table;
}

AnimationTable::Row time_row(std::string name, std::string doc,
                             std::optional<double> SceneAnimation::*member) {
  const yaml::Key form = form::computed("s");
  return {std::move(name), std::move(doc), form,
          [=](SceneAnimation& animation, const yaml::Node& node, const query::NamesReading& read) {
            const auto time = read.number(node, form);
            const double stop = read.names.diagram ? read.names.diagram->diagram().stop : 0.0;
            if (time && (*time < 0.0 || (stop > 0.0 && *time > stop)))
              read.fault(node.mark,
                         fmt::format("{} is not within the run, which lasts {} s", node.text, stop));
            animation.*member = time;
          }};
}

const AnimationTable& animation_table() {
  static const AnimationTable table(
      "an animation", "{from: 1 s, to: 6 s}",
      {time_row("from", "time in the run at which it begins", &SceneAnimation::from),
       time_row("to", "time in the run at which it ends", &SceneAnimation::to),
       {"speed", "seconds of the run in one second of the animation", form::above_zero(form::computed()),
        &SceneAnimation::speed},
       {"where", "of several runs, that with the first row for which this is true; without it the first",
        form::expression(), &SceneAnimation::where}});
  return table;
}

void read_objects(Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "'objects' are a map of name: object, such as {hand: {ball: rig.position}}");
  for (const yaml::Entry& entry : node.entries) {
    const query::NamesReading object_read("scene." + entry.key, read.names, read.faults);
    if (auto object = read_scene_object(entry, scene.formulas, object_read))
      scene.objects.push_back(std::move(*object));
  }
}

void read_animation(Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  SceneAnimation& animation = scene.animation;
  if (!animation_table().read(node, animation, read)) return;
  if (animation.from && animation.to && !(*animation.from < *animation.to))
    yaml::below(read, "to").fault(node.find("to")->mark, "the end of an animation is behind its beginning");
}

void read_background(Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  scene.background = node.text;
  if (node.is_scalar() && (node.text == "dark" || node.text == "light")) return;
  if (const auto color = read_scene_color(node.text, node.mark, {"dark", "light"}, read))
    scene.background = color->value;
}

const SceneTable& scene_table() {
  static const SceneTable table(
      "a scene", "{view: {x: [-5 mm, 5 mm], y: [-5 mm, 5 mm]}, objects: {..}}",
      {yaml::needed(
           SceneTable::Row{"view", "what is seen of the plane", view_table().form,
                           [](Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
                             view_table().read(node, scene, read);
                           }}),
       yaml::needed(SceneTable::Row{
           "objects", "by name, in the order in which they are drawn: {hand: {ball: rig.position}}",
           form::names(scene_object_form(), 1), read_objects}),
       yaml::otherwise("dark",
                       SceneTable::Row{"background", "dark, light, or a colour",
                                       form::either({form::word({"dark", "light"}), scene_color_form()}),
                                       read_background}),
       {"pointer", "what a pointer in the picture moves, where the scene is live", scene_pointer_form(),
        [](Scene&, const yaml::Node& node, const query::NamesReading& read) {
          read_scene_pointer(node, read);  // for its faults: a run without a page has no pointer
        }},
       {"animation", "what of the run scene.svg shows; without it the whole run", animation_table().form,
        read_animation}});
  return table;
}

std::size_t recording_of(const Scene& scene, const yaml::Node& node, const query::NamesReading& read) {
  std::vector<const query::Formula*> formulas;
  for (const query::Formula& formula : scene.formulas) formulas.push_back(&formula);
  if (scene.animation.where) formulas.push_back(&*scene.animation.where);
  return query::common_recording(formulas, read.names, node, read.subject, read.faults);
}

}  // namespace

const yaml::Key& scene_form() {
  return scene_table().form;
}

Scene read_scene(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  const query::NamesReading read("scene", names, faults);
  Scene scene;
  scene.mark = node.mark;
  if (!scene_table().read(node, scene, read)) return scene;
  scene.recording = recording_of(scene, node, read);
  for (const query::RecordedName& state : scene_state_names(scene))  // names must be unique
    if (names.find(state.name))
      read.fault(node.mark,
                 fmt::format("'{}' is recorded already, and would be what the scene shows; rename its object",
                             state.name));
  return scene;
}

}  // namespace stepwire::scene
