#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/loop_settings.hpp"
#include "engine/simulate/realtime/cyclictest.hpp"
#include "engine/simulate/realtime/loop.hpp"
#include "engine/simulate/realtime/serve.hpp"

namespace stepwire::session {

/// Numbers of written and lost rows of a loop.
struct LoopRows {
  std::int64_t written = 0;
  std::int64_t lost_to_ring = 0;  ///< lost because the writer was too slow
  std::int64_t lost_to_disk = 0;
  std::string trouble;  ///< error of the file system

  std::int64_t lost() const { return lost_to_ring + lost_to_disk; }
};

/// Results of a loop; `loop` has the measurements.
struct LoopOutcome {
  const realtime::Loop& loop;
  const LoopSettings& settings;
  realtime::Served served;
  std::optional<LoopRows> rows;  ///< std::nullopt if no rows were recorded
  std::optional<realtime::Cyclictest> baseline;
};

}  // namespace stepwire::session
