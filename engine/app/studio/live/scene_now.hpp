#pragma once

#include <optional>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// Scene of a file at the newest tick of its run.
class SceneNow {
 public:
  /// The run must have a scene and outlive it.
  explicit SceneNow(LoadedRun& run);

  /// Returns the static part: view, objects, walls, and the inputs that a pointer writes.
  json::Json description() const;
  /// Returns the shapes; std::nullopt before the first tick.
  std::optional<json::Json> news() const;

 private:
  LoadedRun& run_;
  const scene::Scene& scene_;
  std::vector<double> fixed_;         ///< values of columns that are no signals
  std::vector<std::size_t> columns_;  ///< columns of the store
  std::vector<std::size_t> places_;   ///< their indices in a row
  std::optional<scene::SceneView> view_;
};

}  // namespace stepwire::live
