#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "engine/app/studio/live/run_control.hpp"
#include "engine/simulate/run/drive.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/tiered_execution.hpp"

namespace stepwire::live {

/// Compiler of the plan of a live run, in the background and only for runs that are long enough. Parameters
/// of the diagram can be set in the compiled code. Setting any other value triggers a new compilation with
/// that value as a variable.
class LiveCode {
 public:
  /// Plan and source must outlive it; without a source the run is interpreted.
  LiveCode(const plan::Plan& plan, plan::CodeSource* source);

  /// Counts computed ticks, and switches the run to compiled code once that is available.
  void look(run::Executor& run, std::int64_t ticks);
  /// Records that a value was set, so that the next compilation makes it a variable.
  void was_set(const std::string& name);

 private:
  void compile();

  const plan::Plan& plan_;
  plan::CodeSource* source_;
  std::set<std::string> names_;  ///< names that can be set in compiled code
  std::vector<plan::VariableBlock> variable_;
  std::unique_ptr<run::TieredExecution> code_;
};

/// Checkpoints of a run, for returning to an earlier tick. They are taken at a regular interval and thinned
/// out with age, so that they stay within a memory limit.
class Moments {
 public:
  /// `every`: ticks between two checkpoints.
  explicit Moments(std::int64_t every, std::size_t bytes = std::size_t{256} << 20)
      : every_(every), bytes_(bytes) {}

  /// True if a checkpoint is due at this tick.
  bool due(std::int64_t tick) const { return tick >= next_; }
  /// Stores a checkpoint between two ticks; its tick must be after all stored ones.
  void keep(const run::Workspace& workspace);
  /// Returns the last checkpoint at or before a tick, or nullptr.
  const run::Workspace* before(std::int64_t tick) const;
  /// Removes the checkpoints after a tick.
  void cut(std::int64_t tick);
  std::size_t size() const { return kept_.size(); }

 private:
  void thin();

  std::int64_t every_, next_ = 0;
  std::size_t bytes_;
  std::vector<run::Workspace> kept_;
};

/// Simulated run in a thread of its own. Calls of other threads take effect between two ticks. Values that
/// are set and inputs that are written are logged with their tick. A return to an earlier tick reproduces the
/// same bits from a checkpoint and the log, then continues with the present values.
class RunThread : public RunControl, private run::RunObserver {
 public:
  struct Options {
    plan::CodeSource* code = nullptr;  ///< nullptr: the run is interpreted
    StoreOptions store{};
    std::uint32_t run = 0;          ///< number of the run
    std::function<void()> changed;  ///< called by the run's thread; must return soon
  };

  /// Computes tick 0 and pauses. Plan and signals must outlive it.
  RunThread(const plan::Plan& plan, const SignalList& signals, Options options);
  ~RunThread() override;

  void play(double rate) override;
  void pause() override;
  std::int64_t one_tick() override;
  void restart() override;
  std::int64_t seek(double time) override;

 private:
  /// Run of the plan, from its start or from a checkpoint.
  struct Life {
    explicit Life(const plan::Plan& plan) : run(plan), drive(run, no_recorders) {}
    run::Executor run;
    std::vector<record::Recorder> no_recorders;
    run::Drive drive;
  };

  const run::Executor& executor() const override { return life_->run; }
  std::int64_t apply_now(const LiveEvent& event) override;
  void select() override;
  void describe(RunStatus& status) const override;
  run::Flow before_tick(const run::ObservedRun&) override;
  void evaluated(const run::ObservedRun&) override;

  template <class Act>
  void act(const Act& act);
  void go_to(std::int64_t tick);
  void main();
  void begin_life();
  void live();
  void rest();
  bool wait_for_turn();
  void arrive();
  bool is_due();
  void hand_over();
  void wait_until(std::optional<double> time);
  void do_events(std::int64_t tick);
  void add_event(LiveEvent event);
  void start_anew();
  void go_back(std::int64_t tick);
  void carry_values(std::int64_t tick);
  void put_past(std::uint32_t life, const std::vector<RowGathering::Incomplete>& columns,
                const std::vector<std::vector<double>>& samples);

  LiveCode code_;
  Moments moments_;
  std::unique_ptr<Life> life_;
  std::atomic<bool> quits_ = false;
  bool plays_ = false, ended_ = false;
  bool is_paced_ = false;               ///< true after the pace has a first tick
  std::optional<double> stored_input_;  ///< RunStatus::input
  double flushed_ = 0.0;
  std::int64_t goal_ = 0;                        ///< computed without the clock up to here
  std::int64_t known_ = 0;                       ///< replays the log before this tick
  std::optional<std::int64_t> back_to_;          ///< pending restart or seek
  std::shared_ptr<std::promise<void>> arrived_;  ///< waits for `goal_`; may be nullptr
  std::string fault_;
  std::atomic<bool> past_interrupt_ = false;
  std::thread past_;    ///< computes missing samples
  std::thread thread_;  ///< last: uses the other members
};

}  // namespace stepwire::live
