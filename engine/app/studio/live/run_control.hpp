#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/query/formula.hpp"
#include "engine/app/studio/live/event_log.hpp"
#include "engine/app/studio/live/live_inputs.hpp"
#include "engine/app/studio/live/sample_store.hpp"

namespace stepwire::live {

/// State of a run.
struct RunStatus {
  enum class State { playing, paused, ended };
  State state = State::paused;
  std::uint32_t run = 0;    ///< increases with each restart and seek
  std::int64_t tick = 0;    ///< last computed tick
  double time = 0.0;        ///< its time [s]
  double rate = 0.0;        ///< recent simulated seconds per second of the clock
  double wanted = 1.0;      ///< requested rate; 0: as fast as possible
  std::int64_t missed = 0;  ///< ticks more than 20 ms late
  bool compiled = false;
  /// Page time of the newest input sample that has acted by a stored tick [s].
  std::optional<double> input;
  std::string fault;  ///< reason of a failure, else empty
};

/// Outcome of set().
struct SetResult {
  std::optional<double> value;  ///< SI; std::nullopt if it is no number
  std::string text;
  std::int64_t tick = 0;  ///< first tick with the new value
};

/// Interface for pages to control and observe a run. Thread-safe; calls return after they have taken effect.
class RunControl {
 public:
  virtual ~RunControl() = default;

  /// Starts or continues the run. `rate`: simulated seconds per second of the clock; 0: as fast as possible.
  virtual void play(double rate) = 0;
  virtual void pause() = 0;
  /// Computes one tick and returns its number.
  virtual std::int64_t one_tick() = 0;
  /// Starts the run again with the present values.
  virtual void restart() = 0;
  /// Moves to a time as fast as possible, backwards from a checkpoint; returns the target tick.
  virtual std::int64_t seek(double time) = 0;
  /// Sets a value. Throws Error if the run refuses it.
  virtual SetResult set(const std::string& name, const std::string& text) = 0;
  /// Queues a sample of an input. Throws Error for a wrong count of numbers. Returns at once.
  virtual void input(const InputSample& sample) = 0;
  /// Resets the inputs that this client wrote last to their defaults, from the next tick on.
  virtual void release(int client) = 0;
  /// Records that a client is alive; any of its messages counts.
  virtual void heard(int) {}
  /// Returns the column of the store for a signal of the list, and starts storing it if needed.
  virtual std::size_t stored(std::size_t signal) = 0;
  /// Returns the column of the store for a formula, and starts storing it if needed.
  virtual std::size_t stored(const query::Formula& formula) = 0;

  virtual RunStatus status() const = 0;
  virtual const SampleStore& store() const = 0;
  virtual EventLog log() = 0;
  /// Returns the present value of a parameter in SI; std::nullopt if it is no number.
  virtual std::optional<double> value(const std::string& parameter) = 0;
  /// Returns the timing of a real-time loop, as in the news `loop`; std::nullopt for a simulation.
  virtual std::optional<json::Json> timing() { return std::nullopt; }
};

}  // namespace stepwire::live
