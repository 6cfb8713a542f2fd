#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/simulate/realtime/deadlines.hpp"
#include "engine/simulate/realtime/real_time_thread.hpp"

namespace stepwire::session {

/// What a call of `loop` may ask, as written.
struct LoopWords {
  std::string rate = "1000", duration = "10", policy = "fifo:80", overrun = "skip", spin = "0";
  std::optional<int> cpu;
};

/// What it asks, checked.
struct LoopSettings {
  double rate = 0.0;      ///< [Hz]
  double duration = 0.0;  ///< [s]
  std::int64_t deadlines = 0;
  std::int64_t spin = 0;  ///< [ns]
  realtime::ThreadPolicy policy;
  realtime::Overrun overrun;
  std::optional<int> cpu;
};

/// Throws Error with all that is wrong.
LoopSettings read_loop_settings(const LoopWords& words);

}  // namespace stepwire::session
