#pragma once

#include <cstdint>

namespace stepwire::live {

/// When ticks are due by the clock, at a rate that may change. Times are seconds of one clock.
class Pace {
 public:
  explicit Pace(double step) : step_(step) {}

  /// Seconds of the run in one of the clock; 0: as fast as it goes.
  double rate() const { return rate_; }
  /// From now on the run goes at a rate, and this tick is due now.
  void begin(double rate, std::int64_t tick, double now);
  /// When a tick is due; now where there is no rate.
  double due(std::int64_t tick, double now) const {
    return rate_ > 0.0 ? start_ + static_cast<double>(tick - first_) * step_ / rate_ : now;
  }
  /// Notes a tick that is begun. One that comes more than 20 ms late is missed, and a run that is 200 ms
  /// behind does not try to catch up.
  void begun(std::int64_t tick, double now);
  std::int64_t missed() const { return missed_; }
  /// How many seconds of the run came in one of the clock lately, over half a second.
  double measured() const { return measured_; }

 private:
  double step_, rate_ = 1.0, start_ = 0.0, measured_ = 0.0;
  std::int64_t first_ = 0, missed_ = 0;
  double marked_ = 0.0;  ///< when measuring began
  std::int64_t marked_tick_ = 0;
};

}  // namespace stepwire::live
