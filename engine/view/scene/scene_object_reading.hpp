#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/view/scene/scene.hpp"

namespace stepwire {

/// Reads one object, NAME: {KIND: .., color: ..}; its formulas are added to those of the scene.
std::optional<SceneObject> read_scene_object(const Entry& entry, const Names& names,
                                             std::vector<Formula>& formulas, Faults& faults);

/// A colour by its name or as "#rrggbb"; a fault names the colours there are, and the `other` words that may
/// stand here.
std::optional<SceneColor> read_scene_color(const std::string& text, Mark mark,
                                           const std::vector<std::string>& other, const Names& names,
                                           const std::string& subject, Faults& faults);

}  // namespace stepwire
