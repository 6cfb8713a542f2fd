#pragma once

#include <vector>

#include "engine/view/scene/scene.hpp"

namespace stepwire::scene {

/// Returns the states of a scene as columns of 0 and 1, for claims and figures. Column scene.NAME.COLOUR is 1
/// while the object has that colour, of those that it can have. Column scene.NAME.shown is 1 while it is
/// visible, if that may change. Several walls of which one turns red have columns scene.NAME.1.COLOUR, ...,
/// in the order of the region's boundary lines.
std::vector<query::RecordedName> scene_state_names(const Scene& scene);

/// Adds these columns to the recording of the scene.
void add_scene_states(const Scene& scene, std::vector<record::Recording>& recordings);

}  // namespace stepwire::scene
