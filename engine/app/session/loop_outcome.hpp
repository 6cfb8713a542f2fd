#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/loop_settings.hpp"
#include "engine/simulate/realtime/cyclictest.hpp"
#include "engine/simulate/realtime/loop.hpp"
#include "engine/simulate/realtime/serve.hpp"

namespace stepwire::session {

/// What became of the rows of a loop.
struct LoopRows {
  std::int64_t written = 0;
  std::int64_t lost_to_ring = 0;  ///< the writer was too slow
  std::int64_t lost_to_disk = 0;
  std::string trouble;  ///< what the system said of the disk

  std::int64_t lost() const { return lost_to_ring + lost_to_disk; }
};

/// All that a loop has to report; the loop itself tells what it measured.
struct LoopOutcome {
  const realtime::Loop& loop;
  const LoopSettings& settings;
  realtime::Served served;
  std::optional<LoopRows> rows;  ///< none where nothing was recorded
  std::optional<realtime::Cyclictest> baseline;
};

}  // namespace stepwire::session
