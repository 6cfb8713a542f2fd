#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/observed_ticks.hpp"
#include "engine/simulate/run/stop_condition.hpp"

namespace stepwire::run {

/// Runs a simulation tick by tick: records it, calls its observers, and ends it at the stop time or
/// condition.
class Drive : SideObserver {
 public:
  /// Number of ticks between two checks of the interrupt flag.
  static constexpr std::int64_t ticks_between_looks = 256;

  enum class End {
    finished,  ///< At the stop time, by `stop_when`, or by a fault of the simulation.
    stopped,   ///< By an observer.
    paused,    ///< By an observer, or before the tick `until`; run() continues.
    interrupted
  };

  Drive(Executor& simulation, std::vector<record::Recorder>& recorders);
  ~Drive() { simulation_.show_sides(nullptr); }
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  std::size_t index = 0;                         ///< Index of the run, for observers.
  std::span<RunObserver* const> observers;       ///< Must outlive the drive.
  bool shows_rows = true;                        ///< True if the observers read the recorded rows.
  bool judges_steps = true;                      ///< Enables the checks for unstable steps.
  const std::atomic<bool>* interrupt = nullptr;  ///< Ends the run once true; its rows stay.
  std::int64_t until = std::numeric_limits<std::int64_t>::max();  ///< Tick before which run() pauses.
  bool ends = true;            ///< False for a run by the clock, which stop time and `stop_when` do not end.
  std::function<void()> look;  ///< Callback of every `ticks_between_looks` ticks.

  /// Runs to the end, or until an observer pauses or stops the run.
  End run();

 private:
  void before_instant(const double* values) override { record_side(values, record::Recorder::Side::before); }
  void after_event(const double* values) override { record_side(values, record::Recorder::Side::after); }
  void record_side(const double* values, record::Recorder::Side side);
  void record(bool last);
  bool is_last() const;
  void prepare_checks();
  void check_steps(bool last);
  void forget_row_of_end();
  Flow show_tick();
  /// Ends a run whose step has had a fault; at an event this instant has a row.
  End end_by_fault();
  End end(End how);

  Executor& simulation_;
  std::vector<record::Recorder>& recorders_;
  StopConditionEvaluator stopper_;
  std::optional<ObservedTicks> watched_;                                ///< set by the first call of run()
  std::int64_t next_check_ = std::numeric_limits<std::int64_t>::max();  ///< tick of next_step_check()
};

}  // namespace stepwire::run
