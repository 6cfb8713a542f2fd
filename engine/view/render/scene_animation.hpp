#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/view/scene/scene.hpp"

namespace stepwire::render {

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
