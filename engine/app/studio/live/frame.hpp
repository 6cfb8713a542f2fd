#pragma once

#include <cstdint>
#include <string>

#include "engine/app/studio/live/sample_store.hpp"

namespace stepwire::live {

/// Header fields of a data frame.
struct FrameHead {
  std::uint16_t view = 0;
  std::uint32_t sequence = 0;
  std::uint32_t run = 0;
};

/// Returns a data frame: a header of 32 bytes, then columns of little-endian doubles, the time first. The
/// time of a row of extremes is the middle of its ticks.
std::string frame(const FrameHead& head, const SampleRows& rows, const SampleStore& store);

}  // namespace stepwire::live
