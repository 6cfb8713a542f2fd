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
  /// Behind all of the same tick and before.
  void add(LiveEvent event);
  /// Forgets what was done at a tick and later.
  void cut(std::int64_t tick);
  const std::vector<LiveEvent>& events() const { return events_; }
  /// Hands on what was done at ticks from, ..., to - 1.
  void each(std::int64_t from, std::int64_t to, const std::function<void(const LiveEvent&)>& take) const;

  /// The last event of each name at a tick before `to`, in their order.
  std::vector<LiveEvent> last_of_each(std::int64_t to = std::numeric_limits<std::int64_t>::max()) const;

  json::Json json() const;
  /// Throws std::runtime_error for what json() does not write.
  static EventLog read(const json::Json& list);

 private:
  std::vector<LiveEvent> events_;
};

/// Does to a run what the event says. Throws Error where that is refused.
void apply(const LiveEvent& event, run::Executor& run);

/// The present number of a parameter of a run, SI; of any other value that of the text by which it was set.
/// Nothing where it is no number.
std::optional<double> present_number(const run::Executor& run, const std::string& name,
                                     const std::string& text);

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
