#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire {

/// The keys of an object, and what stands for a colour.
const Key& scene_object_form();
const Key& scene_color_form();

/// Reads one object, NAME: {KIND: .., color: ..}; its formulas are added to those of the scene.
std::optional<SceneObject> read_scene_object(const Entry& entry, std::vector<Formula>& formulas,
                                             const NamesReading& read);

/// A colour by its name or as "#rrggbb"; a fault names the colours there are, and the `other` words that may
/// stand here.
std::optional<SceneColor> read_scene_color(const std::string& text, Mark mark,
                                           const std::vector<std::string>& other, const NamesReading& read);

}  // namespace stepwire
