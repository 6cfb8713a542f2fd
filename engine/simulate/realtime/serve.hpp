#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/realtime/loop.hpp"
#include "engine/simulate/realtime/real_time_thread.hpp"

namespace stepwire::realtime {

/// Actual scheduling of a loop's thread.
struct Served {
  std::vector<std::string> refused;  ///< see RealTimeThread::refused
  std::string policy;                ///< effective policy: "fifo:80"
};

/// Serves `deadlines` deadlines of a loop in a real-time thread of its own, and waits for it.
Served serve_in_real_time(Loop& loop, std::int64_t deadlines, const ThreadPolicy& policy,
                          std::optional<int> cpu);

}  // namespace stepwire::realtime
