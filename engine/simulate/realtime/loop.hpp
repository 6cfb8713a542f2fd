#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/realtime/deadlines.hpp"
#include "engine/simulate/realtime/device.hpp"
#include "engine/simulate/realtime/group_costs.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"
#include "engine/simulate/realtime/loop_recorder.hpp"
#include "engine/simulate/realtime/measurements.hpp"
#include "engine/simulate/realtime/signal_tap.hpp"
#include "engine/simulate/realtime/thread_counts.hpp"
#include "engine/simulate/realtime/value_exchange.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/observed_ticks.hpp"

namespace stepwire::realtime {

/// How often a loop wakes, for how long, and what it does about missed deadlines.
struct LoopOptions {
  double rate = 1000.0;        ///< [Hz]
  std::int64_t deadlines = 1;  ///< after which it is done
  Overrun overrun;
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, the loop ends at its next wake-up
  const plan::CompiledPlan* code = nullptr;      ///< to step with; interpreted without it
  /// Called in the loop's thread, within its period; must outlive the loop. One that pauses or stops the run
  /// ends it.
  std::vector<run::RunObserver*> observers{};
  const std::atomic<bool>* pause = nullptr;  ///< once true, serve() returns after its next deadline
  SignalTap* tap = nullptr;                  ///< gets every tick
  ValueExchange* values = nullptr;  ///< whose active run is stepped, without observers; null: one of its own
};

/// How many ticks one period of the rate is. Throws Error where it is no whole number of the diagram's steps.
std::int64_t ticks_per_period(const diagram::Diagram& diagram, double rate);

/// Throws Error for every block that says of itself that it is not fit for a real-time loop.
void require_fit_for_loop(const plan::Plan& plan);

/// A diagram in real time: at each deadline the inputs are read, the tick of that moment is evaluated, the
/// outputs are written, and only then are the states advanced, through all further ticks of the period; so
/// that the outputs are as young as can be. The file's stop and stop_when do not end it.
///
/// serve() neither allocates, locks, prints nor calls the system, but for the sleep between two steps. What
/// deadlines(), measurements() and group_costs() count may be read by other threads meanwhile; one count may
/// be a deadline ahead of another then.
class Loop {
 public:
  /// `stopped`: after deadlines that were missed, or by an observer.
  enum class End { done, stopped, interrupted, fault };

  /// Takes all memory, and runs some ticks and goes back to time 0, so that nothing is met for the first time
  /// later. `recorder` may be null. Plan, device, clock and recorder must outlive the loop.
  Loop(const plan::Plan& plan, const LoopOptions& options, Device& device, LoopClock& clock,
       LoopRecorder* recorder);

  /// Serves deadlines until `count` more have passed, all have, or the loop ends early; then hands the safe
  /// values to the device. The first one comes after a lead of one period, 10 ms at least. May be called
  /// again while not ended(); diagram time does not go on in between.
  void serve(std::int64_t count);

  bool ended() const { return end_.has_value(); }
  /// How it ended; `done` as long as nothing ended it early.
  End end() const { return end_.value_or(End::done); }
  const run::Executor& simulation() const { return *simulation_; }
  const Deadlines& deadlines() const { return deadlines_; }
  const Measurements& measurements() const { return measurements_; }
  std::vector<GroupCost> group_costs() const { return groups_.costs(); }
  /// What the thread did while it served.
  const ThreadCounts& counts() const { return counts_; }
  std::int64_t steps() const { return measurements_.step().count(); }

 private:
  void warm_up();
  void prepare_inputs();
  void prepare_outputs();
  void wait_and_step(std::int64_t end);
  void drop_missed(std::int64_t now, std::int64_t end);
  void step(std::int64_t woke);
  void go_on(double wall);
  void read_inputs();
  void write_outputs();
  void count_written(std::int64_t k);
  bool may_tick();
  void record(double wall);
  void write_safe_values();
  bool pauses() const { return options_.pause && *options_.pause; }

  LoopOptions options_;
  std::int64_t ticks_;  ///< per period
  Device& device_;
  LoopClock& clock_;
  LoopRecorder* recorder_;
  std::optional<run::Executor> own_;
  run::Executor* simulation_;
  run::ObservedTicks watched_;
  Deadlines deadlines_;
  Measurements measurements_;
  GroupCosts groups_;
  ThreadCounts counts_;
  std::vector<double> inputs_, outputs_;
  std::vector<std::size_t> input_offsets_;   ///< in inputs_, for each input of the diagram
  std::vector<std::size_t> output_offsets_;  ///< in the workspace, for each number of outputs_
  std::vector<std::optional<double>> safe_;  ///< for each number of outputs_
  std::optional<std::int64_t> began_;        ///< time of the first deadline [ns]
  std::int64_t unwritten_ = 0;               ///< the first deadline that still waits for outputs
  std::optional<End> end_;
};

}  // namespace stepwire::realtime
