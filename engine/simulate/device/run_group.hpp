#pragma once

#include <cstdint>
#include <vector>

#include "engine/simulate/device/device.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/stop_condition.hpp"

namespace stepwire::device {

/// Returns the memory of a device that a run takes, without its rows [bytes].
std::size_t memory_of_run(const plan::Plan& plan, std::size_t table);

/// Runs of one plan that a device steps together, from time 0. Each run ends by itself, at the tick at which
/// it would end alone.
///
/// The device makes a piece of ticks at a time. Its length follows from the memory for rows, and from the
/// time of the last piece, so that an interruption is seen soon. Where only last rows are kept, no row leaves
/// the device: the last row is made of the numbers of the run at its end.
class RunGroup {
 public:
  struct Run {
    run::Executor* simulation;
    std::vector<record::Recorder>* recorders;
  };

  /// `runs` has at least one run; all must outlive this object. Throws DeviceError, as step() and finish()
  /// do.
  RunGroup(Device& device, Kernel& kernel, const std::vector<plan::VariableBlock>& variable,
           std::vector<Run> runs);

  /// True if the kernel was made for the numbers of these runs.
  bool fits() const { return fits_; }
  bool goes_on() const { return active_ > 0; }
  /// Steps a piece of ticks, or until all runs have ended.
  void step();
  /// Loads the states of all runs into their executors. Returns for each run whether it was still active,
  /// which ends it between two ticks.
  std::vector<bool> finish();

  static constexpr double longest_piece = 0.2;  ///< Duration of a piece that is aimed at [s].

 private:
  static constexpr std::int32_t taken_out =
      1000;  ///< End of a run that has been taken out before the others.

  bool gather();
  void allocate();
  std::int64_t ticks_of_rows() const;
  void read_ends();
  void write_rows(const Piece& piece);
  void check_steps();
  bool has_stable_steps(std::size_t run);
  void take_out(std::size_t run);
  std::vector<double> values_of(std::size_t run) const;

  Device& device_;
  Kernel& kernel_;
  const std::vector<plan::VariableBlock>& variable_;
  std::vector<Run> runs_;
  const plan::Plan& plan_;
  run::StopConditionEvaluator stopper_;
  std::int64_t next_check_;  ///< tick of next_step_check()
  bool keeps_rows_;
  std::size_t active_;
  std::int64_t tick_ = 0, length_ = 64;
  std::size_t table_ = 0;        ///< size of the table of a run
  std::vector<double> values_;   ///< workspaces in the layout of a Piece
  std::vector<double> numbers_;  ///< tables in the same
  std::vector<double> rows_;
  std::vector<std::int32_t> ends_, ends_before_;
  std::vector<std::int64_t> ticks_;
  bool fits_;
  struct Memory {
    DeviceNumbers<double> values, numbers, rows;
    DeviceNumbers<std::int32_t> ends;
    DeviceNumbers<std::int64_t> ticks;
  };
  std::unique_ptr<Memory> memory_;
};

}  // namespace stepwire::device
