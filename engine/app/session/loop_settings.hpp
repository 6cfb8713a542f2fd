#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/simulate/realtime/deadlines.hpp"
#include "engine/simulate/realtime/real_time_thread.hpp"

namespace stepwire::session {

/// Options of `loop` as text.
struct LoopWords {
  std::string rate = "1000", duration = "10", policy = "fifo:80", overrun = "skip", spin = "0";
  std::optional<int> cpu;
};

/// Checked options of `loop`.
struct LoopSettings {
  double rate = 0.0;      ///< [Hz]
  double duration = 0.0;  ///< [s]
  std::int64_t deadlines = 0;
  std::int64_t spin = 0;  ///< [ns]
  realtime::ThreadPolicy policy;
  realtime::Overrun overrun;
  std::optional<int> cpu;
};

/// Checks the options. Throws Error with all faults.
LoopSettings read_loop_settings(const LoopWords& words);

}  // namespace stepwire::session
