#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/query/formula.hpp"
#include "engine/app/studio/live/event_log.hpp"
#include "engine/app/studio/live/live_inputs.hpp"
#include "engine/app/studio/live/sample_store.hpp"

namespace stepwire::live {

/// How a run stands.
struct RunStatus {
  enum class State { playing, paused, ended };
  State state = State::paused;
  std::uint32_t run = 0;    ///< counts up with restart and seek
  std::int64_t tick = 0;    ///< that was computed last
  double time = 0.0;        ///< of it [s]
  double rate = 0.0;        ///< seconds of the run in one of the clock, lately
  double wanted = 1.0;      ///< the same as it should be; 0: as fast as it goes
  std::int64_t missed = 0;  ///< ticks that came more than 20 ms late
  bool compiled = false;
  /// Of the newest sample of an input that acted by a tick which is stored, as its page sent it [s].
  std::optional<double> input;
  std::string fault;  ///< that ended it; empty where none did
};

/// What set() came to.
struct SetResult {
  std::optional<double> value;  ///< SI; nothing where it is no number
  std::string text;
  std::int64_t tick = 0;  ///< from which on it holds
};

/// What pages have a run do, and what they see of it. Calls may come from any thread, and return once they
/// have taken effect.
class RunControl {
 public:
  virtual ~RunControl() = default;

  /// `rate`: seconds of the run in one of the clock; 0: as fast as it goes.
  virtual void play(double rate) = 0;
  virtual void pause() = 0;
  /// Returns which tick it will be.
  virtual std::int64_t one_tick() = 0;
  /// Begins anew with the values that are set now.
  virtual void restart() = 0;
  /// Goes to a time as fast as it goes, back by a kept moment; returns the tick to which it goes.
  virtual std::int64_t seek(double time) = 0;
  /// Throws Error where the value is refused.
  virtual SetResult set(const std::string& name, const std::string& text) = 0;
  /// Numbers for an input, at a time of seconds_now(); throws Error where their count is wrong. Returns at
  /// once.
  virtual void input(const InputSample& sample) = 0;
  /// Inputs that this client has written last have their defaults from the next tick on.
  virtual void release(int client) = 0;
  /// This client has said something, whatever it was: it is there.
  virtual void heard(int) {}
  /// The column of the store that has a signal of the list, which is stored from now on at the latest.
  virtual std::size_t stored(std::size_t signal) = 0;
  /// The same for a formula.
  virtual std::size_t stored(const query::Formula& formula) = 0;

  virtual RunStatus status() const = 0;
  virtual const SampleStore& store() const = 0;
  virtual EventLog log() = 0;
  /// The present value of a parameter, SI; nothing where it is no number.
  virtual std::optional<double> value(const std::string& parameter) = 0;
  /// How well a real-time loop keeps time, as the news `loop`; nothing of what is no such loop.
  virtual std::optional<json::Json> timing() { return std::nullopt; }
};

}  // namespace stepwire::live
