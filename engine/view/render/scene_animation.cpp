#include "engine/view/render/scene_animation.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/render/scene_drawing.hpp"

namespace stepwire::render {
namespace {

constexpr double frames_per_second = 20.0;  // enough with linear motion in between
constexpr std::size_t min_frames = 2, max_frames = 600;

[[noreturn]] void nothing_to_show(const scene::Scene& scene, const std::string& file, const char* what) {
  throw yaml::Error(yaml::Fault{{file, scene.mark}, "scene.animation", what, {}});
}

std::string drawn(const scene::Scene& scene, const record::Recording& recording, const AnimationRows& chosen,
                  const std::string& title) {
  const scene::SceneView view = scene::view_of(scene, recording);
  std::vector<svg::SvgElement> frames;
  for (const std::size_t row : chosen.rows) {
    frames.push_back(scene_sheet(scene, scene_width, scene_height(scene), title));
    frames.back().add(scene_frame(scene, view.shapes(scene::row_of(recording, row))));
  }
  return svg::animated_svg(frames, chosen.seconds);
}

}  // namespace

AnimationRows animation_rows(const scene::Scene& scene, const std::string& file,
                             const record::Recording& recording, std::size_t most) {
  const query::RunRows run = query::rows_of_run(scene.animation.where, recording);
  if (run.none()) nothing_to_show(scene, file, "no row is left to be drawn");
  const std::vector<double>& time = recording.table.columns.front().values;
  std::vector<std::size_t> all;
  for (std::size_t row = run.begin; row < run.end; ++row)
    if (time[row] >= scene.animation.from.value_or(time[run.begin]) &&
        time[row] <= scene.animation.to.value_or(time[run.end - 1]))
      all.push_back(row);
  if (all.size() < min_frames) nothing_to_show(scene, file, "fewer than two rows are left to be drawn");
  const double between = (time[all[1]] - time[all[0]]) / scene.animation.speed;
  const auto smooth =
      static_cast<std::size_t>(std::max(1.0, std::round(1.0 / (frames_per_second * between))));
  const std::size_t step = std::min(all.size() - 1, std::max(smooth, (all.size() - 1) / (most - 1) + 1));
  AnimationRows chosen;
  // Counted from the last row, which often is the result of a run.
  for (std::size_t i = (all.size() - 1) % step; i < all.size(); i += step) chosen.rows.push_back(all[i]);
  chosen.seconds = (time[chosen.rows.back()] - time[chosen.rows.front()]) / scene.animation.speed;
  return chosen;
}

std::string animated_scene(const scene::Scene& scene, const std::string& file,
                           std::span<const record::Recording> recordings, const std::string& title) {
  const record::Recording& recording = recordings[scene.recording];
  for (std::size_t most = max_frames;; most = most * 2 / 3) {
    const AnimationRows rows = animation_rows(scene, file, recording, most);
    std::string picture = drawn(scene, recording, rows, title);
    if (picture.size() <= largest_animation || rows.rows.size() <= 2 * min_frames) return picture;
  }
}

}  // namespace stepwire::render
