#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/app/studio/live/command_queue.hpp"
#include "engine/app/studio/live/event_log.hpp"
#include "engine/app/studio/live/live_code.hpp"
#include "engine/app/studio/live/live_inputs.hpp"
#include "engine/app/studio/live/moments.hpp"
#include "engine/app/studio/live/pace.hpp"
#include "engine/app/studio/live/row_gathering.hpp"
#include "engine/app/studio/live/run_control.hpp"
#include "engine/simulate/run/drive.hpp"

namespace stepwire::live {

/// Computes a run on a thread of its own, as others have it go on: each call takes effect between two ticks.
/// What is set and what is written to inputs is logged with its tick; a return to an earlier moment computes
/// the same bits again and goes on with the values that are set now.
class RunThread : public RunControl, private run::RunObserver {
 public:
  struct Options {
    plan::CodeSource* code = nullptr;  ///< null: all is interpreted
    StoreOptions store{};
    std::uint32_t run = 0;          ///< number of the run
    std::function<void()> changed;  ///< called by the run's thread; must return soon
  };

  /// Computes the tick of time 0, and is paused then. Plan and signals must outlive it.
  RunThread(const plan::Plan& plan, const SignalList& signals, Options options);
  ~RunThread() override;

  void play(double rate) override;
  void pause() override;
  std::int64_t one_tick() override;
  void restart() override;
  std::int64_t seek(double time) override;
  SetResult set(const std::string& name, const std::string& text) override;
  void input(const InputSample& sample) override;
  void release(int client) override;
  std::size_t stored(std::size_t signal) override;
  std::size_t stored(const query::Formula& formula) override;

  RunStatus status() const override;
  const SampleStore& store() const override { return rows_.store(); }
  EventLog log() override;
  std::optional<double> value(const std::string& parameter) override;

 private:
  /// One run of the plan, from its start or from a moment on.
  struct Life {
    explicit Life(const plan::Plan& plan) : run(plan), drive(run, no_recorders) {}
    run::Executor run;
    std::vector<record::Recorder> no_recorders;
    run::Drive drive;
  };

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
  void fill_past();
  void put_past(std::uint32_t life, const std::vector<RowGathering::Incomplete>& columns,
                const std::vector<std::vector<double>>& samples);
  std::int64_t next_tick() const { return shown_ + 1; }
  void tell();

  const plan::Plan& plan_;
  Options options_;
  CommandQueue commands_;
  LiveCode code_;
  RowGathering rows_;
  LiveInputs inputs_;
  Moments moments_;
  Pace pace_;
  EventLog log_;
  std::unique_ptr<Life> life_;
  std::atomic<bool> quits_ = false;
  bool plays_ = false, ended_ = false;
  bool is_paced_ = false;                ///< does the pace know the next tick?
  std::optional<double> stored_input_;   ///< RunStatus::input
  double flushed_ = 0.0;                 ///< when rows were handed to the store last
  std::int64_t shown_ = -1;              ///< the tick that was computed last; -1: none
  std::int64_t goal_ = 0;                ///< up to this tick it goes as fast as it goes
  std::int64_t known_ = 0;               ///< ticks before this one are computed again, as the log has them
  std::optional<std::int64_t> back_to_;  ///< the tick at which another life begins
  std::shared_ptr<std::promise<void>> arrived_;  ///< of who waits for the goal; null: nobody
  std::uint32_t lives_;                          ///< number of this one
  std::string fault_;
  mutable std::mutex status_mutex_;
  RunStatus status_;
  std::atomic<bool> past_interrupt_ = false;
  std::thread past_;    ///< for samples that columns miss
  std::thread thread_;  ///< last: it uses the others
};

}  // namespace stepwire::live
