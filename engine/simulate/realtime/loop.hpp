#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/realtime/deadlines.hpp"
#include "engine/simulate/realtime/device.hpp"
#include "engine/simulate/realtime/exchange.hpp"
#include "engine/simulate/realtime/group_costs.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"
#include "engine/simulate/realtime/loop_recorder.hpp"
#include "engine/simulate/realtime/measurements.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/observed_ticks.hpp"

namespace stepwire::realtime {

/// Rate and length of a loop, and its policy for missed deadlines.
struct LoopOptions {
  double rate = 1000.0;        ///< [Hz]
  std::int64_t deadlines = 1;  ///< number of deadlines after which it ends
  Overrun overrun;
  const std::atomic<bool>* interrupt = nullptr;  ///< flag that ends the loop at its next wake-up once true
  const plan::CompiledPlan* code = nullptr;      ///< compiled code; nullptr: interpreted
  /// Observers, called in the loop's thread within its period; must outlive the loop. An observer that pauses
  /// or stops the run ends the loop.
  std::vector<run::RunObserver*> observers{};
  const std::atomic<bool>* pause = nullptr;  ///< flag that makes serve() return after its next deadline
  SignalTap* tap = nullptr;                  ///< receives every tick
  ValueExchange* values = nullptr;  ///< source of the run to step, without observers; nullptr: own run
};

/// Returns the number of ticks in a period of the rate. Throws Error if the period is no whole multiple of
/// the diagram's step.
std::int64_t ticks_per_period(const diagram::Diagram& diagram, double rate);

/// Throws Error for every block that is declared unfit for a real-time loop.
void require_fit_for_loop(const plan::Plan& plan);

/// Diagram in real time.
///
/// At each deadline the loop reads the inputs, evaluates the tick and writes the outputs. Only then does it
/// advance the states, through all further ticks of the period, so the outputs have the smallest delay. The
/// file's stop and stop_when have no effect.
///
/// serve() neither allocates, locks, prints nor makes system calls, except for the sleep between two steps.
/// Other threads may read the counts of deadlines(), measurements() and group_costs() concurrently; one count
/// may then be a deadline ahead of another.
class Loop {
 public:
  /// `stopped` is the end by missed deadlines or by an observer; `device` is that by an unhealthy device.
  enum class End { done, stopped, interrupted, fault, device };

  /// Allocates all memory, and runs some ticks and returns to time 0, so that no later tick is slow for the
  /// first time. `recorder` may be nullptr. Plan, device, clock and recorder must outlive the loop.
  Loop(const plan::Plan& plan, const LoopOptions& options, Device& device, LoopClock& clock,
       LoopRecorder* recorder);

  /// Serves deadlines until `count` more have passed, all have passed, or the loop ends early. Then writes
  /// the safe values to the device. The first deadline is after one period, at least 10 ms. May be called
  /// again unless ended(); diagram time does not advance in between.
  void serve(std::int64_t count);

  bool ended() const { return end_.has_value(); }
  /// Returns how it ended; `done` if nothing ended it early.
  End end() const { return end_.value_or(End::done); }
  const run::Executor& simulation() const { return *simulation_; }
  const Deadlines& deadlines() const { return deadlines_; }
  const Measurements& measurements() const { return measurements_; }
  std::vector<GroupCost> group_costs() const { return groups_.costs(); }
  /// Returns the resource usage of the thread while it served.
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
  bool read_inputs(std::int64_t began);
  bool is_healthy();
  void serve_outputs(std::int64_t k);
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
  std::vector<std::size_t> input_offsets_;   ///< Place of each input of the diagram in inputs_.
  std::vector<std::size_t> output_offsets_;  ///< Place of each number of outputs_ in the workspace.
  std::vector<std::optional<double>> safe_;  ///< One for each number of outputs_.
  std::optional<std::int64_t> began_;        ///< Time of the first deadline [ns].
  std::int64_t unwritten_ = 0;               ///< First deadline without outputs.
  std::int64_t written_at_ = 0;              ///< Time of the last outputs.
  std::optional<End> end_;
};

}  // namespace stepwire::realtime
