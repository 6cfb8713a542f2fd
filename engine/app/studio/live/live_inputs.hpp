#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/studio/live/event_log.hpp"

namespace stepwire::live {

/// Numbers for an input that a client has read at a time.
struct InputSample {
  int client = 0;
  double time = 0.0;  ///< of seconds_now() [s]
  std::string name;
  std::vector<double> values;         ///< SI
  std::optional<double> page_time{};  ///< the same on the clock of the page, as it sent it
};

/// The defaults of all inputs of a diagram, SI.
std::vector<std::vector<double>> defaults_of_inputs(const plan::Plan& plan);

/// Samples for the inputs of a diagram, which wait for the tick of their time.
class LiveInputs {
 public:
  /// The plan must outlive it.
  explicit LiveInputs(const plan::Plan& plan);

  /// From any thread; of more than 4096 that wait the oldest is dropped. Throws Error for an input that is
  /// not there, or takes another count of numbers.
  void push(InputSample sample);
  /// From any thread: what this client has written last is to be the default from now on.
  void release(int client);
  /// The events of all samples up to a time, in the order in which they came; `tick` is computed next.
  std::vector<LiveEvent> take(double time, std::int64_t tick);
  /// The connected page that wrote each input last; 0: none.
  std::vector<int> writers();
  /// The time of the newest sample that was taken, as its page sent it; nothing before the first. For the
  /// thread that takes.
  std::optional<double> taken() const { return taken_; }

 private:
  std::size_t find(const std::string& name) const;

  const plan::Plan& plan_;
  std::vector<std::vector<double>> defaults_;  ///< of each input
  std::mutex mutex_;
  std::vector<InputSample> waiting_;
  std::map<std::string, int> writers_;  ///< who has written an input last
  std::atomic<bool> any_ = false;
  std::optional<double> taken_;
};

}  // namespace stepwire::live
