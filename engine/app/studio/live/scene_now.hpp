#pragma once

#include <optional>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// The scene of a file at the newest tick of its run.
class SceneNow {
 public:
  /// The run has a scene and must outlive it.
  explicit SceneNow(LoadedRun& run);

  /// What does not move: view, objects, walls, and which inputs a pointer feeds.
  json::Json description() const;
  /// What is shown; nothing before the first tick.
  std::optional<json::Json> news() const;

 private:
  LoadedRun& run_;
  const scene::Scene& scene_;
  std::vector<double> fixed_;         ///< values of the columns that no signal has
  std::vector<std::size_t> columns_;  ///< of the store
  std::vector<std::size_t> places_;   ///< of these in a row
  std::optional<scene::SceneView> view_;
};

}  // namespace stepwire::live
