#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace stepwire::realtime {

/// Wait-free triple buffer for the newest row of numbers from one thread to another. Each thread owns one of
/// three rows; the third one was passed last. No row is read while it is written.
class LatestValues {
 public:
  explicit LatestValues(const std::vector<double>& first) { rows_.fill(first); }

  /// Passes a row with as many numbers as the first one. For the writing thread.
  void give(std::span<const double> values) {
    std::ranges::copy(values, rows_[given_].begin());
    given_ = handed_.exchange(given_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }
  /// Returns the newest row, valid until the next call. For the reading thread.
  std::span<const double> take() {
    if (handed_.load(std::memory_order_relaxed) & fresh)
      taken_ = handed_.exchange(taken_, std::memory_order_acq_rel) & ~fresh;
    return rows_[taken_];
  }

 private:
  static constexpr std::uint32_t fresh = 4;  // flag beside the index of a row

  std::array<std::vector<double>, 3> rows_;
  std::uint32_t given_ = 0, taken_ = 1;  ///< index of each thread's own row
  std::atomic<std::uint32_t> handed_ = 2;
};

}  // namespace stepwire::realtime
