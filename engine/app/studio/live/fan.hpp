#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// A sweep of one parameter between two values, in runs of their own.
struct FanCall {
  std::string name;
  double low = 0.0, high = 0.0;  ///< SI
  std::size_t count = 2;
  std::vector<std::size_t> columns;
};

/// Runs it to the end of the run, with the values that are set in the run now beside it; the points have
/// about 1000 samples each. Ends with what it has once `interrupt` is true. Throws Error where a value is
/// refused.
json::Json fan(LoadedRun& run, const FanCall& call, const std::atomic<bool>& interrupt);

/// What each block of the model takes of a step, measured in a short run of its own.
json::Json profile_now(const LoadedRun& run, const std::atomic<bool>& interrupt);

}  // namespace stepwire::live
