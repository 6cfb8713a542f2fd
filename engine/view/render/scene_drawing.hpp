#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_spec.hpp"
#include "engine/view/scene/scene.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::render {

/// How wide a scene is drawn [px].
constexpr double scene_width = 480.0;

/// How high it is then [px]: a metre is as long upward as to the right.
double scene_height(const scene::Scene& scene);

/// One instant as an <svg> of its own, without what all instants share. For any instant of a scene it has the
/// same elements and attributes, with other values.
svg::SvgElement scene_frame(const scene::Scene& scene, const std::vector<scene::SceneShape>& shapes);

/// The colours of light on balls and of the background, to which frames refer.
svg::SvgElement scene_definitions(const scene::Scene& scene);

/// A whole picture of that size [px], with the definitions, for frames to be added.
svg::SvgElement scene_sheet(const scene::Scene& scene, double width, double height, const std::string& title);

/// Instants side by side, each with the words below it; empty words take no room.
std::string scene_still(const plot::SceneInstants& instants, const std::string& title);

}  // namespace stepwire::render
