#pragma once

#include <array>
#include <optional>
#include <string>

#include "engine/analyse/query/names_reading.hpp"

namespace stepwire::scene {

/// Signals that a pointer in the picture of a scene drives, in place of their sources in the file. One of
/// `place`, `force` and `motion` is set.
struct ScenePointer {
  std::string place;                  ///< Position [m] that is set to that of the pointer.
  std::string force;                  ///< Force [N] of a hand on the pin, which follows the pointer.
  std::string position, velocity;     ///< Motion of that pin.
  std::array<std::string, 3> motion;  ///< Position, velocity, acceleration of such a pin.
  std::string load;                   ///< Force [N] that the hand has to exert to move that pin.
  yaml::Mark mark;
};

/// Returns the keys of `pointer` in a scene.
const yaml::Key& scene_pointer_form();

/// Reads the value of `pointer` in a scene; collects all faults in `read`. The caller must check that the
/// diagram has such signals.
std::optional<ScenePointer> read_scene_pointer(const yaml::Node& node, const query::NamesReading& read);

}  // namespace stepwire::scene
