#pragma once

#include <array>
#include <optional>
#include <string>

#include "engine/analyse/query/names_reading.hpp"

namespace stepwire::scene {

/// What a pointer in the picture of a scene moves, in the place of who or what moves it in the file; names of
/// signals. One of `place`, `force` and `motion` is there.
struct ScenePointer {
  std::string place;                  ///< a place [m]: it is where the pointer is
  std::string force;                  ///< of a hand on the pin [N]: that of a hand which the pointer leads
  std::string position, velocity;     ///< of that pin
  std::array<std::string, 3> motion;  ///< position, velocity, acceleration of a pin: those of such a hand
  std::string load;                   ///< the force that moves that pin [N], which the hand has to make
  yaml::Mark mark;
};

/// The keys of `pointer` in a scene.
const yaml::Key& scene_pointer_form();

/// Reads what stands under the key `pointer` of a scene. Everything that is wrong goes to the faults of
/// `read`; whether the diagram has such signals is looked at by who uses them.
std::optional<ScenePointer> read_scene_pointer(const yaml::Node& node, const query::NamesReading& read);

}  // namespace stepwire::scene
