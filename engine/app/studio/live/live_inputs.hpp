#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/studio/live/event_log.hpp"

namespace stepwire::live {

/// Sample of an input that a client has read.
struct InputSample {
  int client = 0;
  double time = 0.0;  ///< by the clock of seconds_now() [s]
  std::string name;
  std::vector<double> values;         ///< SI
  std::optional<double> page_time{};  ///< same time by the clock of the page, as sent
};

/// Returns the default values of all inputs of a diagram, SI.
std::vector<std::vector<double>> defaults_of_inputs(const plan::Plan& plan);

/// Queue of samples for the inputs of a diagram, until the tick of their time.
class LiveInputs {
 public:
  /// The plan must outlive it.
  explicit LiveInputs(const plan::Plan& plan);

  /// Appends a sample; thread-safe. Beyond 4096 samples the oldest is dropped. Throws Error for an unknown
  /// input or a wrong count of numbers.
  void push(InputSample sample);
  /// Resets the inputs that this client wrote last to their defaults; thread-safe.
  void release(int client);
  /// Returns the events of all samples up to `time`, in order of arrival; `tick` is the next tick.
  std::vector<LiveEvent> take(double time, std::int64_t tick);
  /// Returns for each input the connected page that wrote it last, or 0.
  std::vector<int> writers();
  /// Returns the page time of the newest sample taken; std::nullopt before the first one. Only for the thread
  /// that calls take().
  std::optional<double> taken() const { return taken_; }

 private:
  std::size_t find(const std::string& name) const;

  const plan::Plan& plan_;
  std::vector<std::vector<double>> defaults_;  ///< defaults of each input
  std::mutex mutex_;
  std::vector<InputSample> waiting_;
  std::map<std::string, int> writers_;  ///< client that wrote an input last
  std::atomic<bool> any_ = false;
  std::optional<double> taken_;
};

}  // namespace stepwire::live
