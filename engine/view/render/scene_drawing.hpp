#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_spec.hpp"
#include "engine/view/scene/scene.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::render {

/// Width of a drawn scene [px].
constexpr double scene_width = 480.0;

/// Returns the height of a drawn scene [px], at equal scales of both axes.
double scene_height(const scene::Scene& scene);

/// Returns one instant as a nested <svg>, without the shared definitions. All instants of a scene have the
/// same elements and attributes, with other values.
svg::SvgElement scene_frame(const scene::Scene& scene, const std::vector<scene::SceneShape>& shapes);

/// Returns the gradients of balls and of the background, which frames refer to.
svg::SvgElement scene_definitions(const scene::Scene& scene);

/// Returns a picture of that size [px] with the definitions, to which frames can be added.
svg::SvgElement scene_sheet(const scene::Scene& scene, double width, double height, const std::string& title);

/// Returns instants side by side, each with its words below it; empty words need no space.
std::string scene_still(const plot::SceneInstants& instants, const std::string& title);

}  // namespace stepwire::render
