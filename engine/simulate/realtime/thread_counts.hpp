#pragma once

#include <cstdint>
#include <optional>

namespace stepwire::realtime {

/// What a thread has caused so far, as the kernel and the allocator count it.
struct ThreadCounts {
  std::int64_t minor_faults = 0;            ///< pages that had to be mapped
  std::int64_t major_faults = 0;            ///< pages that had to be read from a disk
  std::int64_t voluntary = 0;               ///< context switches because it waited
  std::int64_t involuntary = 0;             ///< context switches because another was to run
  std::optional<std::int64_t> allocations;  ///< requests for memory; absent where nobody counts

  static ThreadCounts now();
  /// Adds what came about between two moments.
  void add(const ThreadCounts& from, const ThreadCounts& to);
};

}  // namespace stepwire::realtime
