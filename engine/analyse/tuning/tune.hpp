#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_result.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::tuning {

/// What a call may change about a tuning.
struct TuneOptions {
  unsigned threads = 0;  ///< 0: all cores; the result is the same to the last bit
  std::function<void(double fraction, const std::string& what)> progress{};
  messages::ItemWorkers* workers = nullptr;  ///< that search from the starts; null: this process does
};

/// Finds the parameters that make the objective of a file as small as its claims allow. Throws Error for what
/// is wrong with the request, and where no start can be run. What was interrupted before the first run was
/// done has no numbers.
TuneResult tune(const TuneSource& source, const run::Job& job, const TuneRequest& request,
                const TuneOptions& options = {});

}  // namespace stepwire::tuning
