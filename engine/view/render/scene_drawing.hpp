#pragma once

#include <span>
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

/// Returns a picture of that size [px] with the definitions, to which frames can be added.
svg::SvgElement scene_sheet(const scene::Scene& scene, double width, double height, const std::string& title);

/// Returns instants side by side, each with its words below it; empty words need no space.
std::string scene_still(const plot::SceneInstants& instants, const std::string& title);

/// Rows of a recording in an animation, at equal distances in time.
struct AnimationRows {
  std::vector<std::size_t> rows;
  double seconds = 0.0;  ///< length of the animation
};

/// Returns enough rows of the animated run for smooth motion, at most `most`, including its last one. Throws
/// Error if there are fewer than two.
AnimationRows animation_rows(const scene::Scene& scene, const std::string& file,
                             const record::Recording& recording, std::size_t most);

/// Largest file of an animation [bytes].
constexpr std::size_t largest_animation = 280'000;

/// Returns the animated scene as SVG, with no more frames than the largest file permits. Throws Error if the
/// recording has no row to show.
std::string animated_scene(const scene::Scene& scene, const std::string& file,
                           std::span<const record::Recording> recordings, const std::string& title);

}  // namespace stepwire::render
