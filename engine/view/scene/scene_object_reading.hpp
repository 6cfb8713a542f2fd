#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::scene {

/// Return the keys of an object, and the form of a colour.
const yaml::Key& scene_object_form();
const yaml::Key& scene_color_form();

/// Reads one object, NAME: {KIND: .., color: ..}; its formulas are added to those of the scene.
std::optional<SceneObject> read_scene_object(const yaml::Entry& entry, std::vector<query::Formula>& formulas,
                                             const query::NamesReading& read);

/// Reads a colour by its name or as "#rrggbb". A fault lists the colours and the `other` allowed words.
std::optional<SceneColor> read_scene_color(const std::string& text, yaml::Mark mark,
                                           const std::vector<std::string>& other,
                                           const query::NamesReading& read);

}  // namespace stepwire::scene
