#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_result.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::tuning {

/// Options of a call that are not part of the file.
struct TuneOptions {
  unsigned threads = 0;  ///< 0: all cores. The result is the same to the last bit.
  std::function<void(double fraction, const std::string& what)> progress{};
  messages::ItemWorkers* workers =
      nullptr;  ///< Processes that search from the starts; nullptr: this process does.
};

/// Minimises the objective of a file subject to its claims. Throws Error for faults of the request, and if no
/// start can be run. Without a finished run (interrupted) the result has no numbers.
TuneResult tune(const TuneSource& source, const run::Job& job, const TuneRequest& request,
                const TuneOptions& options = {});

}  // namespace stepwire::tuning
