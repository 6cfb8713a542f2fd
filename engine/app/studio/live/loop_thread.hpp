#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/app/session/loop_settings.hpp"
#include "engine/app/studio/live/run_control.hpp"
#include "engine/base/result/record.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/realtime/device.hpp"
#include "engine/simulate/realtime/exchange.hpp"
#include "engine/simulate/realtime/loop.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"
#include "engine/simulate/realtime/real_time_thread.hpp"

namespace stepwire::live {

/// Timing of a real-time loop for the page: the news `loop`.
struct LoopNews {
  const realtime::Loop* loop;
  double rate;  ///< [Hz]
  std::uint32_t run;
  std::int64_t lost;
  std::string policy;
  std::vector<std::string> refused;
};
void declare(result::Record<LoopNews>& is);
/// Returns the types of the news `loop` in TypeScript: loop_news.ts of the page.
std::string loop_news_typescript();

/// Device of a real-time loop whose inputs are written by pages. An input has the value of the last page that
/// wrote it, until that value expires; then it has its default. The loop thread checks the expiry itself, so
/// a lost page or a blocked hub cannot hold an input for longer. Outputs are ignored.
class PageDevice : public realtime::Device {
 public:
  /// Plan and clock must outlive it.
  PageDevice(const plan::Plan& plan, realtime::LoopClock& clock);

  void read(double* inputs) noexcept override;
  void write(const double*) noexcept override {}

  /// Sets the values of an input, valid until a time of the clock [ns]; give() passes them to the loop. For
  /// one other thread.
  void put(std::size_t input, const std::vector<double>& values, std::int64_t until);
  /// Extends the validity of the values of an input.
  void extend(std::size_t input, std::int64_t until) {
    row_[inputs_[input].first] = static_cast<double>(until);
  }
  void give() { latest_.give(row_); }

 private:
  struct Input {
    std::size_t first;  ///< index in a row of the expiry time, before the values
    std::vector<double> defaults;
  };

  realtime::LoopClock& clock_;
  std::vector<Input> inputs_;
  std::vector<double> row_;
  realtime::LatestValues latest_;
};

/// Real-time loop with pages as observers. The loop thread serves deadlines; a second thread, the hub,
/// connects it with all others. The loop thread sends rows through a ring, and its counters. Between two
/// ticks it takes values of inputs, and executors with new parameters. It waits neither for the hub nor for a
/// page.
class LoopThread : public RunControl {
 public:
  struct Options {
    session::LoopSettings settings;
    StoreOptions store{};
    std::uint32_t run = 0;            ///< number of the run
    std::function<void()> changed{};  ///< called by the hub; must return soon
    double patience = 0.5;            ///< [s] silence after which a page that writes inputs counts as lost
  };

  /// Allocates all memory of the loop, but does not start it. Plan and signals must outlive it. Throws Error
  /// for a plan that no loop can run.
  LoopThread(const plan::Plan& plan, const SignalList& signals, Options options);
  /// Stops the loop; outputs get their safe values.
  ~LoopThread() override;

  void play(double rate) override;
  void pause() override;
  std::int64_t one_tick() override;
  void restart() override;
  std::int64_t seek(double time) override;
  void input(const InputSample& sample) override;
  void release(int client) override;
  void heard(int client) override;
  std::optional<json::Json> timing() override;

 private:
  /// Loop from its start to its end.
  struct Life {
    Life(const plan::Plan& plan, const session::LoopSettings& settings, realtime::LoopClock& clock);
    realtime::ValueExchange values;
    realtime::SignalTap tap;
    PageDevice device;
    std::atomic<bool> pause = false;
    std::atomic<bool> done = false;  ///< true after the thread has served
    realtime::Loop loop;
    std::thread thread;
  };

  const run::Executor& executor() const override { return life_->values.active(); }
  std::int64_t apply_now(const LiveEvent& event) override;
  void take_rows() override;
  void select() override;
  void describe(RunStatus& status) const override;

  void main();
  void look();
  void serve();
  void stop_serving();
  void end_thread();
  void begin_life();
  void begin_serving();
  void take_row(std::int64_t tick, const std::vector<std::size_t>& places, std::span<const double> values);
  void note_inputs(std::int64_t tick);
  void hand_inputs();
  void lose_silent_pages(double now);
  bool serves() const { return life_->thread.joinable(); }

  Options options_;
  realtime::SystemClock clock_;
  std::unique_ptr<Life> life_;
  bool quits_ = false;
  std::vector<double> mirror_, absent_;  ///< present workspace as far as known; workspace of NaN
  std::vector<std::vector<double>> seen_inputs_;
  std::map<std::string, double> sampled_;  ///< read time of the newest value of an input at its page [s]
  std::optional<double> handed_, acted_;   ///< page_time of the newest sample passed to the loop, and of the
                                           ///< one in force
  std::string fault_;                      ///< reason of a failure outside the loop
  std::string policy_;                     ///< this and the next two: guarded by status_mutex_
  std::vector<std::string> refused_;
  std::map<int, double> heard_;  ///< time of a client's last message [s]
  std::thread hub_;              ///< last: uses the other members
};

}  // namespace stepwire::live
