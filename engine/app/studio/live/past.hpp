#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "engine/app/studio/live/event_log.hpp"
#include "engine/app/studio/live/row_gathering.hpp"

namespace stepwire::live {

/// Computes a run again for the samples that columns miss, with the events of its log: the bits are the same.
/// Returns a list of samples for each column, from tick 0 to that before its first one. The result is empty
/// after an interruption, where the run ended earlier, and beyond 256 MB.
std::vector<std::vector<double>> past_of(const plan::Plan& plan, const EventLog& log,
                                         std::span<const RowGathering::Incomplete> columns,
                                         const std::atomic<bool>& interrupt);

}  // namespace stepwire::live
