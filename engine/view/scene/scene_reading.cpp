#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/place_reading.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/scene/scene.hpp"
#include "engine/view/scene/scene_object_reading.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire {
namespace {

using Keys = std::vector<std::string>;

constexpr Dimension time_dimension{{0.0, 0.0, 1.0}};

/// Reads the section; faults are gathered.
class SceneReader {
 public:
  SceneReader(const Node& node, const Names& names, Faults& faults)
      : node_(node), names_(names), faults_(faults) {}

  Scene read() {
    scene_.mark = node_.mark;
    if (!node_.is_map()) {
      fault(node_, "scene", "a scene is a map: {view: {x: [-5 mm, 5 mm], y: [-5 mm, 5 mm]}, objects: {..}}");
      return std::move(scene_);
    }
    const Keys known{"view", "objects", "background", "animation"};
    for (const Entry& entry : node_.entries)
      if (std::ranges::find(known, entry.key) == known.end())
        add_unknown_key(entry, known, "a scene", names_, "scene", faults_);
    read_view();
    read_objects();
    if (const Node* background = node_.find("background")) read_background(*background);
    if (const Node* animation = node_.find("animation")) read_animation(*animation);
    find_recording();
    check_states();
    return std::move(scene_);
  }

 private:
  void fault(const Node& node, const std::string& subject, std::string message) {
    faults_.add({{names_.file, node.mark}, subject, std::move(message), {}});
  }

  std::optional<double> number(const Node& node, const std::string& subject, const Dimension& dimension,
                               const std::string& what) {
    const auto number = read_number(node, names_, subject, faults_);
    if (!number) return std::nullopt;
    check_dimension(*number, dimension, what, node, names_, subject, faults_);
    return number->value;
  }

  void read_view() {
    const Node* view = node_.find("view");
    if (!view || !view->is_map())
      return fault(view ? *view : node_, "scene.view",
                   "'view' says what is seen of the plane: {x: [-5 mm, 5 mm], y: [-5 mm, 5 mm]}");
    for (const Entry& entry : view->entries)
      if (entry.key != "x" && entry.key != "y")
        add_unknown_key(entry, {"x", "y"}, "a view", names_, "scene.view", faults_);
    read_range(*view, "x", scene_.x);
    read_range(*view, "y", scene_.y);
  }

  void read_range(const Node& view, const std::string& axis, std::array<double, 2>& range) {
    const std::string subject = "scene.view." + axis;
    const Node* node = view.find(axis);
    if (!node || !node->is_list() || node->items.size() != 2)
      return fault(node ? *node : view, subject, fmt::format("'{}' is two lengths: [-5 mm, 5 mm]", axis));
    const auto low = number(node->items[0], subject, length_dimension, "a length");
    const auto high = number(node->items[1], subject, length_dimension, "a length");
    if (!low || !high) return;
    if (!(*low < *high)) fault(*node, subject, "the first number of a range is below the second");
    range = {*low, *high};
  }

  void read_objects() {
    const Node* objects = node_.find("objects");
    if (!objects || !objects->is_map() || objects->entries.empty())
      return fault(objects ? *objects : node_, "scene.objects",
                   "'objects' are a map of name: object, such as {hand: {ball: rig.position}}");
    for (const Entry& entry : objects->entries)
      if (auto object = read_scene_object(entry, names_, scene_.formulas, faults_))
        scene_.objects.push_back(std::move(*object));
  }

  void read_background(const Node& node) {
    scene_.background = node.text;
    if (node.is_scalar() && (node.text == "dark" || node.text == "light")) return;
    if (const auto color =
            read_scene_color(node.text, node.mark, {"dark", "light"}, names_, "scene.background", faults_))
      scene_.background = color->value;
  }

  void read_animation(const Node& node) {
    SceneAnimation& animation = scene_.animation;
    if (!node.is_map()) return fault(node, "scene.animation", "an animation is a map: {from: 1 s, to: 6 s}");
    Keys known;
    for (const SceneKey& key : scene_animation_keys()) known.push_back(key.name);
    for (const Entry& entry : node.entries) {
      const std::string subject = "scene.animation." + entry.key;
      if (entry.key == "from")
        animation.from = time(entry.value, subject);
      else if (entry.key == "to")
        animation.to = time(entry.value, subject);
      else if (entry.key == "speed")
        animation.speed = speed(entry.value, subject);
      else if (entry.key == "where")
        animation.where = read_formula(entry.value, names_, subject, faults_);
      else
        add_unknown_key(entry, known, "an animation", names_, "scene.animation", faults_);
    }
    if (animation.from && animation.to && !(*animation.from < *animation.to))
      fault(*node.find("to"), "scene.animation.to", "the end of an animation is behind its beginning");
  }

  std::optional<double> time(const Node& node, const std::string& subject) {
    const auto value = number(node, subject, time_dimension, "a time");
    const double stop = names_.diagram ? names_.diagram->diagram().stop : 0.0;
    if (value && (*value < 0.0 || (stop > 0.0 && *value > stop)))
      fault(node, subject, fmt::format("{} is not within the run, which lasts {} s", node.text, stop));
    return value;
  }

  double speed(const Node& node, const std::string& subject) {
    const auto value = number(node, subject, {}, "a speed of time");
    if (!value || *value > 0.0) return value.value_or(1.0);
    fault(node, subject, fmt::format("{} is not allowed; it must be above 0", node.text));
    return 1.0;
  }

  void find_recording() {
    std::vector<const Formula*> formulas;
    for (const Formula& formula : scene_.formulas) formulas.push_back(&formula);
    if (scene_.animation.where) formulas.push_back(&*scene_.animation.where);
    scene_.recording = common_recording(formulas, names_, node_, "scene", faults_);
  }

  /// A name stands for one thing.
  void check_states() {
    for (const RecordedName& state : scene_state_names(scene_))
      if (names_.find(state.name))
        fault(node_, "scene",
              fmt::format("'{}' is recorded already, and would be what the scene shows; rename its object",
                          state.name));
  }

  const Node& node_;
  const Names& names_;
  Faults& faults_;
  Scene scene_;
};

}  // namespace

Scene read_scene(const Node& node, const Names& names, Faults& faults) {
  return SceneReader(node, names, faults).read();
}

}  // namespace stepwire
