#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/simulate/realtime/counter.hpp"

namespace stepwire::realtime {

/// Histogram of times [ns] with a fixed number of bins, so adding one neither allocates nor slows down.
///
/// Up to 256 ns each ns has its bin. Beyond, each power of two is divided into 128 bins of equal width, so
/// the relative resolution is 1/128 or better. Times beyond 73 min share the last bin. Minimum, maximum and
/// sum are exact. One thread adds. Others may read concurrently and may see one count before another.
class Histogram {
 public:
  static constexpr double resolution = 1.0 / 128.0;

  /// Adds a time; negative ones count as 0.
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
  /// Returns the smallest time that at least `fraction` of all do not exceed, e.g. 0.99. It is the upper end
  /// of its bin, at most the maximum; 0 for an empty histogram.
  std::int64_t quantile(double fraction) const;

  static constexpr std::size_t bins() { return bin_count; }
  std::int64_t count_in(std::size_t bin) const { return counts_[bin]; }
  /// Returns the smallest time of a bin, which is the upper end of the previous one.
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
