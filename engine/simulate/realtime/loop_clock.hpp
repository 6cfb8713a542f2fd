#pragma once

#include <cstdint>

namespace stepwire::realtime {

/// Clock of a loop. Times are in ns since an arbitrary origin and increase monotonically.
class LoopClock {
 public:
  virtual ~LoopClock() = default;
  virtual std::int64_t now() = 0;
  /// Returns at the deadline, or at once if it has passed.
  virtual void sleep_until(std::int64_t deadline) = 0;
};

/// Clock with CLOCK_MONOTONIC. The thread sleeps until `spin` [ns] before the deadline and then polls the
/// clock. An awake processor is on time, at the cost of its power.
class SystemClock : public LoopClock {
 public:
  explicit SystemClock(std::int64_t spin = 0) : spin_(spin) {}
  std::int64_t now() override;
  void sleep_until(std::int64_t deadline) override;

 private:
  std::int64_t spin_;
};

}  // namespace stepwire::realtime
