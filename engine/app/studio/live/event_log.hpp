#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/simulate/run/observer.hpp"

namespace stepwire::live {

/// Tick of events before the reset to time 0, such as initial values.
inline constexpr std::int64_t before_start = -1;

/// Change of a run before it computes a tick: a value that is set, or an input that is written.
struct LiveEvent {
  std::int64_t tick = 0;
  std::string name;            ///< parameter, value of a block, or input
  std::string text;            ///< new value, in the syntax of `--set`
  std::vector<double> values;  ///< for an input, SI; else empty
  double time = 0.0;           ///< for an input: read time at the page, by the clock of seconds_now() [s]

  bool is_input() const { return !values.empty(); }
};

/// Log of all changes of a run, in order. A run of the same diagram with the same events yields the same
/// bits.
class EventLog {
 public:
  /// Inserts an event behind those of the same tick.
  void add(LiveEvent event);
  /// Removes the events at `tick` and later.
  void cut(std::int64_t tick);
  const std::vector<LiveEvent>& events() const { return events_; }
  /// Passes on the events at ticks from, ..., to - 1.
  void each(std::int64_t from, std::int64_t to, const std::function<void(const LiveEvent&)>& take) const;

  /// Returns the last event of each name before tick `to`, in order.
  std::vector<LiveEvent> last_of_each(std::int64_t to = std::numeric_limits<std::int64_t>::max()) const;

  json::Json json() const;
  /// Reads what json() writes; throws std::runtime_error for anything else.
  static EventLog read(const json::Json& list);

 private:
  std::vector<LiveEvent> events_;
};

/// Applies an event to a run. Throws Error if the run refuses the value.
void apply(const LiveEvent& event, run::Executor& run);

/// Returns the present value of a parameter in SI, or for other names the number in `text`. std::nullopt if
/// the value is no number.
std::optional<double> present_number(const run::Executor& run, const std::string& name,
                                     const std::string& text);

/// Observer that applies the events of a log to another run of the plan.
class LogReplay : public run::RunObserver {
 public:
  explicit LogReplay(EventLog log) : log_(std::move(log)) {}
  void begin(const run::ObservedRun& run) override;
  run::Flow before_tick(const run::ObservedRun& run) override;

 private:
  void do_events(run::Executor& run, std::int64_t tick) const;

  EventLog log_;
};

}  // namespace stepwire::live
