#pragma once

#include <cstdint>

namespace stepwire::live {

/// Schedule of ticks by the clock, at a rate that may change. Times are seconds of one clock.
class Pace {
 public:
  explicit Pace(double step) : step_(step) {}

  /// Returns simulated seconds per second of the clock; 0: as fast as possible.
  double rate() const { return rate_; }
  /// Sets the rate; `tick` is due now.
  void begin(double rate, std::int64_t tick, double now);
  /// Returns the due time of a tick; `now` for rate 0.
  double due(std::int64_t tick, double now) const {
    return rate_ > 0.0 ? start_ + static_cast<double>(tick - first_) * step_ / rate_ : now;
  }
  /// Records the begin of a tick. A tick that is more than 20 ms late counts as missed. Beyond 200 ms the
  /// schedule shifts instead of catching up.
  void begun(std::int64_t tick, double now);
  std::int64_t missed() const { return missed_; }
  /// Returns the rate measured over the last half second or more.
  double measured() const { return measured_; }

 private:
  double step_, rate_ = 1.0, start_ = 0.0, measured_ = 0.0;
  std::int64_t first_ = 0, missed_ = 0;
  double marked_ = 0.0;  ///< begin of the measurement
  std::int64_t marked_tick_ = 0;
};

}  // namespace stepwire::live
