#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/view/scene/scene.hpp"

namespace stepwire::render {

/// The rows of a recording that an animation shows, at even distances in time.
struct AnimationRows {
  std::vector<std::size_t> rows;
  double seconds = 0.0;  ///< how long the animation lasts
};

/// As many rows of the animated run as move smoothly to the eye, and no more than `most`, its last among
/// them. Throws Error if there are fewer than two.
AnimationRows animation_rows(const scene::Scene& scene, const std::string& file,
                             const record::Recording& recording, std::size_t most);

/// The largest file that an animation is drawn to [bytes].
constexpr std::size_t largest_animation = 280'000;

/// The scene in motion, as SVG that plays wherever pictures are shown: with no more frames than keep it below
/// the largest file. Throws Error where the recording has nothing to show.
std::string animated_scene(const scene::Scene& scene, const std::string& file,
                           std::span<const record::Recording> recordings, const std::string& title);

}  // namespace stepwire::render
