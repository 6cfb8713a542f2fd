#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>

namespace stepwire::live {

/// Returns the time of a monotonic clock of this process [s].
double seconds_now();

/// Queue of commands from other threads, which the run executes in order between two ticks.
class CommandQueue {
 public:
  void push(std::function<void()> command);
  /// True if the queue is empty; takes no lock.
  bool empty() const { return count_.load(std::memory_order_acquire) == 0; }
  /// Executes all commands in order.
  void run_all();
  /// Waits for a command.
  void wait();
  /// Waits for a command, until a time of seconds_now() at most.
  void wait_until(double time);

  /// Executes an action in the run's thread and returns its result. Throws what the action throws;
  /// std::future_error if the queue is destroyed first.
  template <class Act>
  auto ask(Act act) {
    using Result = std::invoke_result_t<Act>;
    const auto task = std::make_shared<std::packaged_task<Result()>>(std::move(act));
    std::future<Result> result = task->get_future();
    push([task] { (*task)(); });
    return result.get();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> commands_;
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace stepwire::live
