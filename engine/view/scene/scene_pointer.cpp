#include "engine/view/scene/scene_pointer.hpp"

namespace stepwire::scene {

using yaml::form;

namespace {

using PointerTable = yaml::KeyTable<ScenePointer, query::NamesReading>;

void read_motion(ScenePointer& pointer, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_list() || node.items.size() != pointer.motion.size())
    return read.fault(node.mark, "is a list of three signals: [pusher.position, pusher.velocity, "
                                 "pusher.acceleration]");
  for (std::size_t i = 0; i < pointer.motion.size(); ++i) pointer.motion[i] = read.text(node.items[i]);
}

PointerTable::Row signal_row(std::string name, std::string doc, std::string ScenePointer::*member) {
  return {std::move(name), std::move(doc), form::text(), member};
}

const PointerTable& pointer_table() {
  const char* const who = "what the pointer moves";
  static const PointerTable table(
      "a pointer", "{force: arm, position: rig.at, velocity: rig.velocity}",
      {yaml::one_of(who, signal_row("place", "a place that is where the pointer is", &ScenePointer::place)),
       yaml::one_of(who, signal_row("force", "force of a hand on a pin: it becomes that of a hand which the "
                                             "pointer leads",
                                    &ScenePointer::force)),
       yaml::one_of(who, PointerTable::Row{"motion",
                                           "position, velocity and acceleration of a pin that is moved: they "
                                           "become those of a hand which the pointer leads",
                                           form::list(form::text(), 3, 3), read_motion}),
       yaml::beside({"force"}, signal_row("position", "of the pin", &ScenePointer::position)),
       yaml::beside({"force"}, signal_row("velocity", "of the pin", &ScenePointer::velocity)),
       yaml::beside({"motion"}, signal_row("load", "force that moves the pin", &ScenePointer::load))});
  return table;
}

}  // namespace

const yaml::Key& scene_pointer_form() {
  return pointer_table().form;
}

std::optional<ScenePointer> read_scene_pointer(const yaml::Node& node, const query::NamesReading& read) {
  ScenePointer pointer;
  pointer.mark = node.mark;
  if (!pointer_table().read(node, pointer, read)) return std::nullopt;
  const bool lacks_pin = !pointer.force.empty() && (pointer.position.empty() || pointer.velocity.empty());
  if (lacks_pin) read.fault(node.mark, "'force' needs 'position' and 'velocity' of the pin beside it");
  const bool lacks_load = !pointer.motion[0].empty() && pointer.load.empty();
  if (lacks_load) read.fault(node.mark, "'motion' needs 'load' beside it, the force that moves the pin");
  return lacks_pin || lacks_load ? std::nullopt : std::optional(pointer);
}

}  // namespace stepwire::scene
