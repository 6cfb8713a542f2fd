#include "engine/cli/interrupt.hpp"

#include <csignal>

namespace stepwire {

namespace {

std::atomic<bool> flag = false;  // a signal handler can reach nothing else
static_assert(std::atomic<bool>::is_always_lock_free);

void handle(int signal) {
  flag = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& interrupted() {
  return flag;
}

void catch_interrupts() {
  std::signal(SIGINT, handle);
  std::signal(SIGTERM, handle);
}

}  // namespace stepwire
