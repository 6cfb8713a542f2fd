#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace stepwire::studio {

/// Worker thread that serves several senders. The work of one sender runs in order. Senders take turns, one
/// work each, so that a sender with much work delays another one by a single work at most. A tick runs
/// periodically.
class Lane {
 public:
  using Work = std::function<void()>;

  /// `tick` runs at least once per period, and once more at the end; an empty function means no tick. Neither
  /// the tick nor any work may throw.
  explicit Lane(Work tick = {}, std::chrono::milliseconds period = std::chrono::milliseconds(250));
  ~Lane() { stop(); }
  Lane(const Lane&) = delete;
  Lane& operator=(const Lane&) = delete;

  /// Appends a work; thread-safe. Does nothing after stop().
  void post(Work work, int sender = 0);
  /// Waits for the running work and drops all waiting ones.
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
  std::deque<Sender> waiting_;  ///< senders with work, in the order of their turns
  bool ends_ = false;
  std::thread thread_;  // last member: starts when all others are initialised
};

}  // namespace stepwire::studio
