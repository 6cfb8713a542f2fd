#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/simulate/run/observer.hpp"

namespace stepwire::live {

/// Stands for what is done before a run puts everything at time 0, such as initial values.
inline constexpr std::int64_t before_start = -1;

/// Something that was done to a run before it computed a tick: a value that was set, or an input written.
struct LiveEvent {
  std::int64_t tick = 0;
  std::string name;            ///< of a parameter, a value of a block or an input
  std::string text;            ///< of a value that is set, as `--set` reads it
  std::vector<double> values;  ///< of an input, SI; else empty
  double time = 0.0;  ///< of an input: when it was read at the page, on the clock of this machine [s]

  bool is_input() const { return !values.empty(); }
};

/// All that was done to a run, in order. A run that begins with the same diagram and gets the same events has
/// the same bits.
class EventLog {
 public:
  void add(LiveEvent event) { events_.push_back(std::move(event)); }
  /// Forgets what was done at a tick and later.
  void cut(std::int64_t tick);
  const std::vector<LiveEvent>& events() const { return events_; }
  /// Hands on what was done at ticks from, ..., to - 1.
  void each(std::int64_t from, std::int64_t to, const std::function<void(const LiveEvent&)>& take) const;

  json::Json json() const;
  /// Throws std::runtime_error for what json() does not write.
  static EventLog read(const json::Json& list);

 private:
  std::vector<LiveEvent> events_;
};

/// Does to a run what the event says. Throws Error where that is refused.
void apply(const LiveEvent& event, run::Executor& run);

/// Does all again in another run of the plan.
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
