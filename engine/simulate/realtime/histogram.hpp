#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/simulate/realtime/counter.hpp"

namespace stepwire::realtime {

/// Counts times [ns] in bins of fixed number, so that adding one neither allocates nor takes longer as there
/// are more. Up to 256 ns each ns has its bin; beyond, each power of two is cut into 128 bins of equal
/// width, so a value is known to 1/128 of itself or better. Times beyond 73 min share the last bin; smallest,
/// largest and sum are exact. One thread adds; others may look on, and may then see one count before another.
class Histogram {
 public:
  static constexpr double resolution = 1.0 / 128.0;

  /// What is below 0 counts as 0.
  void add(std::int64_t time) {
    if (time < 0) time = 0;
    counts_[bin_of(time)].add();
    count_.add();
    sum_.add(time);
    if (time < min_) min_.set(time);
    if (time > max_) max_.set(time);
  }

  std::int64_t count() const { return count_; }
  std::int64_t min() const { return count_ > 0 ? min_.get() : 0; }
  std::int64_t max() const { return max_; }
  double mean() const {
    return count_ > 0 ? static_cast<double>(sum_.get()) / static_cast<double>(count_.get()) : 0.0;
  }
  /// The time that the share `fraction` of all does not exceed, e.g. 0.99: the upper end of its bin, but
  /// never more than the largest; 0 where nothing was counted.
  std::int64_t quantile(double fraction) const;

  static constexpr std::size_t bins() { return bin_count; }
  std::int64_t count_in(std::size_t bin) const { return counts_[bin]; }
  /// Smallest time of a bin; that of the bin after it is its upper end.
  static std::int64_t begin_of(std::size_t bin);

 private:
  static constexpr int precision = 7;  ///< bits
  static constexpr std::int64_t most = std::int64_t{1} << 42;
  static constexpr std::size_t bin_count = (42 - precision + 1) << precision;

  static std::size_t bin_of(std::int64_t time) {
    if (time >= most) return bin_count - 1;
    const int width = std::bit_width(static_cast<std::uint64_t>(time));
    const int shift = width > precision + 1 ? width - (precision + 1) : 0;
    return (static_cast<std::size_t>(shift) << precision) + static_cast<std::size_t>(time >> shift);
  }

  std::array<Counter, bin_count> counts_{};
  Counter count_, sum_, max_;
  Counter min_ = std::numeric_limits<std::int64_t>::max();
};

}  // namespace stepwire::realtime
