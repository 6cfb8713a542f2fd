#pragma once

#include <cstdint>
#include <optional>

namespace stepwire::realtime {

/// Resource usage of a thread so far, as counted by the kernel and the allocator.
struct ThreadCounts {
  std::int64_t minor_faults = 0;            ///< Pages that were mapped.
  std::int64_t major_faults = 0;            ///< Pages that were read from a disk.
  std::int64_t voluntary = 0;               ///< Context switches while the thread waited.
  std::int64_t involuntary = 0;             ///< Context switches to another runnable thread.
  std::optional<std::int64_t> allocations;  ///< Memory requests; std::nullopt if not counted.

  static ThreadCounts now();
  /// Adds the usage between two instants.
  void add(const ThreadCounts& from, const ThreadCounts& to);
};

}  // namespace stepwire::realtime
