#pragma once

#include "engine/app/session/loop_settings.hpp"
#include "engine/base/json/json.hpp"
#include "engine/simulate/realtime/loop.hpp"

namespace stepwire::live {

/// Returns the timing of a loop, which may be running: counts of deadlines, histograms, and the cost of each
/// block type. Histograms of lateness, response and step have bins of a quarter octave. All times in s.
json::Json timing_of(const realtime::Loop& loop, const session::LoopSettings& settings);

}  // namespace stepwire::live
