#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/http/site.hpp"

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

/// Routes messages of pages to the calls that they name, each in the lane of its call, and sends the results
/// back. Within a lane, the calls of one page run in order, and pages take turns.
class Dispatch {
 public:
  using Send = std::function<void(int page, std::string text)>;
  using Acknowledge = std::function<void(int page, std::uint32_t sequence)>;

  Dispatch(const Calls& calls, Send send, Acknowledge acknowledge);

  /// Handles a message of a page; never throws, whatever the message contains.
  void take(int page, const std::string& message, const http::Ticket& ticket);
  /// Waits for the running calls and drops all waiting ones.
  void stop();

 private:
  void answer(int page, const CallRow& row, const Arguments& arguments) const;
  void refuse(int page, const json::Json& request) const;

  const Calls& calls_;
  Send send_;
  Acknowledge acknowledge_;
  std::map<CallRow::Where, Lane> lanes_;
};

}  // namespace stepwire::studio
