#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>

namespace stepwire::live {

/// Seconds on the clock of this process, which goes on steadily.
double seconds_now();

/// What other threads have a run do, one after the other, between two ticks.
class CommandQueue {
 public:
  void push(std::function<void()> command);
  /// Is there nothing to do? Costs no lock.
  bool empty() const { return count_.load(std::memory_order_acquire) == 0; }
  /// Does all there is, in its order.
  void run_all();
  /// Returns once there is something to do.
  void wait();
  /// The same, or at a time of seconds_now().
  void wait_until(double time);

  /// Has the run do something, and waits for its result. Throws what it throws, std::future_error where the
  /// run has gone.
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
