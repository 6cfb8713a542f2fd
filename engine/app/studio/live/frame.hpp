#pragma once

#include <cstdint>
#include <string>

#include "engine/app/studio/live/sample_store.hpp"

namespace stepwire::live {

/// What stands at the head of a data frame.
struct FrameHead {
  std::uint16_t view = 0;
  std::uint32_t sequence = 0;
  std::uint32_t run = 0;
};

/// A data frame as the page reads it: 32 bytes of head, then columns of doubles, the time first; little
/// endian. The time of a row of extremes is the middle of its ticks.
std::string frame(const FrameHead& head, const SampleRows& rows, const SampleStore& store);

}  // namespace stepwire::live
