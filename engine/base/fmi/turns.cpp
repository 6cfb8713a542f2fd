#include "engine/base/fmi/turns.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>

namespace stepwire::fmi {

namespace {

// Number of polls before sleeping: at most 5 us, about the time of waking a process. Where all processors are
// busy, the other process begins when this one sleeps.
constexpr int looks = 150;

void rest() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

static_assert(sizeof(std::atomic<std::uint32_t>) == 4 && std::atomic<std::uint32_t>::is_always_lock_free);

void sleep_while(std::atomic<std::uint32_t>& turn, std::uint32_t value) {
  const timespec most{0, 20'000'000};
  syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&turn), FUTEX_WAIT, value, &most, nullptr, 0);
}

}  // namespace

void pass_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t to) {
  turn.store(to);
  if (sleepers.load() > 0)
    syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&turn), FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

bool await_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t own) {
  for (int i = 0; i < looks; ++i) {
    if (turn.load(std::memory_order_acquire) == own) return true;
    rest();
  }
  sleepers.fetch_add(1);
  const std::uint32_t seen = turn.load();
  if (seen != own) sleep_while(turn, seen);
  sleepers.fetch_sub(1);
  return turn.load() == own;
}

}  // namespace stepwire::fmi
