#include "engine/app/studio/live/command_queue.hpp"

#include <chrono>

namespace stepwire::live {

namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

double seconds_now() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

void CommandQueue::push(std::function<void()> command) {
  {
    const std::lock_guard lock(mutex_);
    commands_.push_back(std::move(command));
    count_.store(commands_.size(), std::memory_order_release);
  }
  changed_.notify_one();
}

void CommandQueue::run_all() {
  while (!empty()) {
    std::function<void()> command;
    {
      const std::lock_guard lock(mutex_);
      command = std::move(commands_.front());
      commands_.pop_front();
      count_.store(commands_.size(), std::memory_order_release);
    }
    command();
  }
}

void CommandQueue::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !commands_.empty(); });
}

void CommandQueue::wait_until(double time) {
  const auto until =
      Clock::time_point(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time)));
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, until, [this] { return !commands_.empty(); });
}

}  // namespace stepwire::live
