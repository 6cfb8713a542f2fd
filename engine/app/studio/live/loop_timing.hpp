#pragma once

#include "engine/app/session/loop_settings.hpp"
#include "engine/base/json/json.hpp"
#include "engine/simulate/realtime/loop.hpp"

namespace stepwire::live {

/// How well a loop keeps time, which may run meanwhile: counts of deadlines, histograms of lateness, response
/// and step in bins of a fourth of an octave, and the cost by type of block. All times in s.
json::Json timing_of(const realtime::Loop& loop, const session::LoopSettings& settings);

}  // namespace stepwire::live
