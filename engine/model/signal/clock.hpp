#pragma once

#include "engine/base/math/tick_times.hpp"

namespace stepwire {

/// Time of the evaluation [s]: the instant of the tick, or of the solver's stage between two ticks.
class Time {
 public:
  operator double() const { return *seconds_; }
  void bind(const double* seconds) { seconds_ = seconds; }

 private:
  const double* seconds_ = nullptr;
};

/// Time between two updates of this block [s].
class Period {
 public:
  operator double() const { return seconds_; }
  /// Returns the time of a number of periods [s], rounded as the times of ticks are.
  double times(double periods) const { return times_(periods); }
  void bind(double seconds) { bind(seconds, tick_times(seconds)); }
  void bind(double seconds, const TickTimes& times) {
    seconds_ = seconds;
    times_ = times;
  }

 private:
  double seconds_ = 0.0;
  TickTimes times_;
};

}  // namespace stepwire
