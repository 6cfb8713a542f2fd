#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace stepwire::realtime {

/// The newest row of numbers that one thread has for one other. Neither waits, and no row is seen half: of
/// three rows each thread has one, and the third is the one that was handed over last.
class LatestValues {
 public:
  explicit LatestValues(const std::vector<double>& first) { rows_.fill(first); }

  /// The thread that gives: as many numbers as the first row had.
  void give(std::span<const double> values) {
    std::ranges::copy(values, rows_[given_].begin());
    given_ = handed_.exchange(given_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }
  /// The thread that takes: good until its next call.
  std::span<const double> take() {
    if (handed_.load(std::memory_order_relaxed) & fresh)
      taken_ = handed_.exchange(taken_, std::memory_order_acq_rel) & ~fresh;
    return rows_[taken_];
  }

 private:
  static constexpr std::uint32_t fresh = 4;  // beside the index of a row

  std::array<std::vector<double>, 3> rows_;
  std::uint32_t given_ = 0, taken_ = 1;  ///< each is known to its thread alone
  std::atomic<std::uint32_t> handed_ = 2;
};

}  // namespace stepwire::realtime
