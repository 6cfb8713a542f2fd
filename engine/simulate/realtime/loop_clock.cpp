#include "engine/simulate/realtime/loop_clock.hpp"

#include <cerrno>
#include <ctime>

namespace stepwire::realtime {

namespace {

constexpr std::int64_t second = 1'000'000'000;

timespec as_timespec(std::int64_t time) {
  return {static_cast<std::time_t>(time / second), static_cast<long>(time % second)};
}

void pause_processor() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

std::int64_t SystemClock::now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<std::int64_t>(time.tv_sec) * second + time.tv_nsec;
}

void SystemClock::sleep_until(std::int64_t deadline) {
  const timespec wake = as_timespec(deadline - spin_);
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
  }
  while (spin_ > 0 && now() < deadline) pause_processor();
}

}  // namespace stepwire::realtime
