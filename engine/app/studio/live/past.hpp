#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "engine/app/studio/live/event_log.hpp"
#include "engine/app/studio/live/row_gathering.hpp"

namespace stepwire::live {

/// Repeats a run with the events of its log, for samples that columns lack; the bits are the same. Returns a
/// list of samples for each column, from tick 0 up to its first stored tick. The list is empty after an
/// interruption, if the run ends early, and beyond 256 MB.
std::vector<std::vector<double>> past_of(const plan::Plan& plan, const EventLog& log,
                                         std::span<const RowGathering::Incomplete> columns,
                                         const std::atomic<bool>& interrupt);

}  // namespace stepwire::live
