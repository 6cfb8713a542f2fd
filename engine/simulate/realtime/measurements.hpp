#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

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

/// Measurements of a loop at each deadline [ns]. A dropped deadline counts with its lateness when the loop
/// was ready again, and with the time until the next outputs. So a deadline that is not served cannot improve
/// the statistics.
class Measurements {
 public:
  /// `deadlines` is their total count, which divides the worst cases over time.
  explicit Measurements(std::int64_t deadlines) : deadlines_(deadlines), worst_(worst_count) {}

  /// Adds the lateness of the wake-up for deadline k.
  void woke(std::int64_t k, std::int64_t lateness) {
    wake_up_.add(lateness);
    raise(worst(k).wake_up, lateness);
  }
  /// Adds the time from deadline k until its outputs were written.
  void wrote(std::int64_t k, std::int64_t response) {
    response_.add(response);
    raise(worst(k).response, response);
  }
  /// Adds the time from the wake-up for deadline k until the thread was ready for the next one.
  void stepped(std::int64_t k, std::int64_t cost) {
    step_.add(cost);
    raise(worst(k).step, cost);
  }

  /// Add the time that a device took to read, and to write.
  void read(std::int64_t time) { reading_.add(time); }
  void wrote_device(std::int64_t time) { writing_.add(time); }

  const Histogram& reading() const { return reading_; }
  const Histogram& writing() const { return writing_; }
  const Histogram& wake_up() const { return wake_up_; }
  const Histogram& response() const { return response_; }
  const Histogram& step() const { return step_; }

  /// Largest times in an interval of the loop's deadlines.
  struct Worst {
    std::int64_t wake_up = 0, step = 0, response = 0;
  };
  static constexpr std::size_t worst_count = 200;
  /// Returns the worst cases in order, each for an equal share of the deadlines.
  const std::vector<Worst>& worst() const { return worst_; }

 private:
  Worst& worst(std::int64_t k) {
    return worst_[static_cast<std::size_t>(k * static_cast<std::int64_t>(worst_count) / deadlines_)];
  }
  static void raise(std::int64_t& largest, std::int64_t value) { largest = std::max(largest, value); }

  std::int64_t deadlines_;
  Histogram wake_up_, response_, step_, reading_, writing_;
  std::vector<Worst> worst_;
};

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
