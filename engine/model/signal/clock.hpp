#pragma once

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
  void bind(double seconds) { seconds_ = seconds; }

 private:
  double seconds_ = 0.0;
};

}  // namespace stepwire
