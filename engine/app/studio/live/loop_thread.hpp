#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/app/session/loop_settings.hpp"
#include "engine/app/studio/live/command_queue.hpp"
#include "engine/app/studio/live/pace.hpp"
#include "engine/app/studio/live/page_device.hpp"
#include "engine/app/studio/live/row_gathering.hpp"
#include "engine/app/studio/live/run_control.hpp"
#include "engine/simulate/realtime/loop.hpp"
#include "engine/simulate/realtime/real_time_thread.hpp"

namespace stepwire::live {

/// A real-time loop under pages: a thread that serves deadlines, and another one, the hub, between it and all
/// others. From the loop thread comes a ring of rows and what it counts; to it go values of inputs and runs
/// with other parameters, which it takes between two ticks. It never waits for the hub, nor for a page.
class LoopThread : public RunControl {
 public:
  struct Options {
    session::LoopSettings settings;
    StoreOptions store{};
    std::uint32_t run = 0;          ///< number of the run
    std::function<void()> changed{};  ///< called by the hub; must return soon
    double patience = 0.5;          ///< [s] of silence after which a page that writes inputs counts as lost
  };

  /// Takes all memory of the loop, which does not run yet. Plan and signals must outlive it. Throws Error for
  /// what is not fit for a loop.
  LoopThread(const plan::Plan& plan, const SignalList& signals, Options options);
  /// Ends the loop; outputs get their safe values.
  ~LoopThread() override;

  void play(double rate) override;
  void pause() override;
  std::int64_t one_tick() override;
  void restart() override;
  std::int64_t seek(double time) override;
  SetResult set(const std::string& name, const std::string& text) override;
  void input(const InputSample& sample) override;
  void release(int client) override;
  void heard(int client) override;
  std::size_t stored(std::size_t signal) override;
  std::size_t stored(const query::Formula& formula) override;

  RunStatus status() const override;
  const SampleStore& store() const override { return rows_.store(); }
  EventLog log() override;
  std::optional<double> value(const std::string& parameter) override;
  std::optional<json::Json> timing() override;

 private:
  /// One loop, from its start.
  struct Life {
    Life(const plan::Plan& plan, const session::LoopSettings& settings, realtime::LoopClock& clock);
    realtime::ValueExchange values;
    realtime::SignalTap tap;
    PageDevice device;
    std::atomic<bool> pause = false;
    std::atomic<bool> done = false;  ///< the thread has served
    realtime::Loop loop;
    std::thread thread;
  };

  void main();
  void look();
  void serve();
  void stop_serving();
  void end_thread();
  void begin_life();
  void begin_serving();
  void select();
  void take_rows();
  void take_row(std::int64_t tick, const std::vector<std::size_t>& places, std::span<const double> values);
  void note_inputs(std::int64_t tick);
  void hand_inputs();
  void lose_silent_pages(double now);
  std::int64_t set_in_loop(const LiveEvent& event);
  void tell();
  bool serves() const { return life_->thread.joinable(); }

  const plan::Plan& plan_;
  Options options_;
  realtime::SystemClock clock_;
  CommandQueue commands_;
  RowGathering rows_;
  LiveInputs inputs_;
  Pace pace_;
  EventLog log_;
  std::unique_ptr<Life> life_;
  bool quits_ = false;
  std::uint32_t lives_;
  std::int64_t shown_ = -1;              ///< the newest tick that came; -1: none
  std::vector<double> mirror_, absent_;  ///< a workspace as far as it is known, and one of which nothing is
  std::vector<std::vector<double>> seen_inputs_;
  std::map<std::string, double> sampled_;  ///< when the newest value of an input was read at its page [s]
  std::optional<double> handed_, acted_;   ///< page_time of the newest sample given to the loop, and in force
  mutable std::mutex told_mutex_;          ///< of what follows
  RunStatus status_;
  std::string policy_;
  std::vector<std::string> refused_;
  std::map<int, double> heard_;  ///< when something came from a client last [s]
  std::thread hub_;              ///< last: it uses the others
};

}  // namespace stepwire::live
