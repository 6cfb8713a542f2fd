#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// Sweep of one parameter between two values, each in a separate run.
struct FanCall {
  std::string name;
  double low = 0.0, high = 0.0;  ///< SI
  std::size_t count = 2;
  std::vector<std::size_t> columns;
};

/// Runs the sweep with the values that are now set in the run. Each point has about 1000 samples. After
/// `interrupt` becomes true, it returns the points so far. Throws std::runtime_error if all are refused.
json::Json fan(LoadedRun& run, const FanCall& call, const std::atomic<bool>& interrupt);

/// Measures the cost of each block per step, in a short separate run.
json::Json profile_now(const LoadedRun& run, const std::atomic<bool>& interrupt);

}  // namespace stepwire::live
