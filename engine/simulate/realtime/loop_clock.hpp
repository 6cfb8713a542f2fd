#pragma once

#include <cstdint>

namespace stepwire::realtime {

/// The time by which a loop lives. Times are in ns since a moment of the clock's own, and only grow.
class LoopClock {
 public:
  virtual ~LoopClock() = default;
  virtual std::int64_t now() = 0;
  /// Returns when the deadline has come, or at once where it has passed.
  virtual void sleep_until(std::int64_t deadline) = 0;
};

/// CLOCK_MONOTONIC. The thread sleeps until `spin` [ns] before the deadline and watches the clock for the
/// rest: a processor that is awake is on time, and costs its power.
class SystemClock : public LoopClock {
 public:
  explicit SystemClock(std::int64_t spin = 0) : spin_(spin) {}
  std::int64_t now() override;
  void sleep_until(std::int64_t deadline) override;

 private:
  std::int64_t spin_;
};

}  // namespace stepwire::realtime
