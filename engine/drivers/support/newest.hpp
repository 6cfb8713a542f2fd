#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <vector>

#include "engine/base/driver/driver.h"

namespace stepwire::support {

/// Returns the time of CLOCK_MONOTONIC [ns].
inline std::int64_t monotonic() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// Newest numbers of a numbered stream of messages, with counts of those that are missing.
class Newest {
 public:
  explicit Newest(std::int64_t stale) : stale_(stale) {}

  void start(std::size_t count) {
    values_.assign(count, 0.0);
    arrived_ = monotonic();
  }
  /// Takes a message if it is newer than the last one. `wrap` is the number of sequence numbers, 0 for 2^64.
  /// After the stale time any number counts as new, because the sender may have started anew.
  bool take(std::uint64_t sequence, std::uint64_t wrap, const double* values) {
    const std::uint64_t mask = wrap == 0 ? ~std::uint64_t{0} : wrap - 1, step = (sequence - sequence_) & mask;
    const std::int64_t now = monotonic();
    const bool follows = seen_ > 0 && now - arrived_ <= stale_;
    if (follows && (step == 0 || step > mask / 2)) {
      ++old_;
      return false;
    }
    lost_ += follows ? step - 1 : 0;
    sequence_ = sequence;
    arrived_ = now;
    ++seen_;
    std::copy_n(values, values_.size(), values_.begin());
    return true;
  }
  void refuse() { ++bad_; }

  /// Gives the newest values; their state is that of driver.h.
  int give(double* values) {
    std::copy(values_.begin(), values_.end(), values);
    age_ = monotonic() - arrived_;
    oldest_ = std::max(oldest_, age_);
    return age_ > stale_ ? STEPWIRE_STALE : STEPWIRE_OK;
  }
  std::uint64_t seen() const { return seen_; }
  std::uint64_t lost() const { return lost_; }
  void report(char* text, std::size_t size) const {
    const auto number = [](std::uint64_t of) { return static_cast<unsigned long long>(of); };
    std::snprintf(
        text, size,
        "%llu messages, %llu lost, %llu out of order, %llu damaged; the oldest values were %.3f ms old",
        number(seen_), number(lost_), number(old_), number(bad_), static_cast<double>(oldest_) * 1e-6);
  }

 private:
  std::int64_t stale_, arrived_ = 0, age_ = 0, oldest_ = 0;
  std::uint64_t sequence_ = 0, seen_ = 0, lost_ = 0, old_ = 0, bad_ = 0;
  std::vector<double> values_;
};

}  // namespace stepwire::support
