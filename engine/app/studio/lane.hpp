#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace stepwire::studio {

/// A thread for the work of several senders. Each sender has its work done in order; senders take turns, one
/// work each, so a sender with much work holds up no other for longer than one of its works. In each period
/// it also does a tick.
class Lane {
 public:
  using Work = std::function<void()>;

  /// `tick` is done at least once in a period, also when the lane ends; nothing where it is empty. Neither it
  /// nor any work may throw.
  explicit Lane(Work tick = {}, std::chrono::milliseconds period = std::chrono::milliseconds(250));
  ~Lane() { stop(); }
  Lane(const Lane&) = delete;
  Lane& operator=(const Lane&) = delete;

  /// From any thread; nothing once it was stopped.
  void post(Work work, int sender = 0);
  /// What is going on comes to its end, what waits is dropped.
  void stop();

 private:
  struct Sender {
    int number;
    std::deque<Work> works;
  };

  void run();
  Work next();

  Work tick_;
  std::chrono::milliseconds period_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Sender> waiting_;  ///< those that have work, in the order of their turns
  bool ends_ = false;
  std::thread thread_;  // begins when all else is there
};

}  // namespace stepwire::studio
