#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/observed_ticks.hpp"
#include "engine/simulate/run/stop_condition.hpp"

namespace stepwire::run {

/// Goes through the ticks of a run: records, stops where the diagram says, shows observers what happens.
class Drive : SideObserver {
 public:
  /// Ticks between two looks at the interrupt flag.
  static constexpr std::int64_t ticks_between_looks = 256;

  enum class End {
    finished,  ///< at the stop time, by `stop_when`, or by a fault of the simulation
    stopped,   ///< by an observer
    paused,    ///< by an observer; run() goes on
    interrupted
  };

  Drive(Executor& simulation, std::vector<record::Recorder>& recorders);
  ~Drive() { simulation_.show_sides(nullptr); }
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  std::size_t index = 0;                         ///< of the run, for observers
  std::span<RunObserver* const> observers;       ///< must outlive the drive
  bool shows_rows = true;                        ///< do the observers read what is recorded?
  bool judges_steps = true;                      ///< looks at the end whether they were far too long
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, the run ends and keeps what it has
  std::function<void()> look;                    ///< called every `ticks_between_looks` ticks

  /// Goes on to the end of the run, or of what observers allow.
  End run();

 private:
  void before_instant(const double* values) override { record_side(values, record::Recorder::Side::before); }
  void after_event(const double* values) override { record_side(values, record::Recorder::Side::after); }
  void record_side(const double* values, record::Recorder::Side side);
  void record(bool last);
  bool is_last() const;
  void forget_row_of_end();
  Flow show_tick();
  End end(End how);

  Executor& simulation_;
  std::vector<record::Recorder>& recorders_;
  StopConditionEvaluator stopper_;
  std::optional<ObservedTicks> watched_;  ///< once it has begun
};

}  // namespace stepwire::run
