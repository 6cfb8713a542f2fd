#include "engine/app/studio/live/run_thread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/yaml/error.hpp"

namespace stepwire::live {

namespace {

constexpr double between_moments = 0.5;   // [s] simulated time between checkpoints
constexpr double ahead = 1e-3;            // [s] by which a tick may be early; no sleep is shorter
constexpr double between_flushes = 4e-3;  // [s]

std::int64_t ticks_between_moments(const plan::Plan& plan) {
  return std::max<std::int64_t>(1, std::llround(between_moments / plan.diagram.step));
}

}  // namespace

RunThread::RunThread(const plan::Plan& plan, const SignalList& signals, Options options)
    : plan_(plan),
      options_(std::move(options)),
      code_(plan, options_.code),
      rows_(signals, plan.diagram.step, options_.store),
      inputs_(plan),
      moments_(ticks_between_moments(plan)),
      pace_(plan.diagram.step),
      lives_(options_.run) {
  status_.run = lives_;
  thread_ = std::thread([this] { main(); });
}

RunThread::~RunThread() {
  quits_ = true;
  commands_.push([] {});
  thread_.join();
  past_interrupt_ = true;
  if (past_.joinable()) past_.join();
}

void RunThread::main() {
  while (!quits_) {
    try {
      begin_life();
      live();
      hand_over();
    } catch (const std::exception& error) {
      fault_ = error.what();
    }
    if (!quits_ && !back_to_) rest();
  }
}

/// Creates a run at its start, or at the checkpoint before the tick to return to.
void RunThread::begin_life() {
  life_.reset();
  life_ = std::make_unique<Life>(plan_);
  ended_ = is_paced_ = false;
  fault_.clear();
  if (back_to_) ++lives_;
  const std::int64_t to = std::exchange(back_to_, std::nullopt).value_or(before_start);
  if (to == before_start)
    start_anew();
  else
    go_back(to);
}

void RunThread::live() {
  run::RunObserver* const self = this;
  life_->drive.observers = {&self, 1};
  life_->drive.shows_rows = false;
  life_->drive.look = [this] {
    code_.look(life_->run, run::Drive::ticks_between_looks);
    tell();
  };
  life_->drive.run();
  if (const auto fault = life_->run.fault()) fault_ = fault->fault.text();
}

/// Waits, after the end of the run, for a restart or seek.
void RunThread::rest() {
  ended_ = true;
  plays_ = false;
  while (!quits_ && !back_to_) {
    tell();
    if (arrived_) std::exchange(arrived_, nullptr)->set_value();
    commands_.wait();
    commands_.run_all();
  }
  tell();
}

run::Flow RunThread::before_tick(const run::ObservedRun& run) {
  const std::int64_t tick = run.simulation.tick();
  if (quits_) return run::Flow::stop;
  if (tick <= known_) do_events(tick);
  if (tick >= known_) {
    if (!wait_for_turn()) return run::Flow::stop;
    for (LiveEvent& event : inputs_.take(seconds_now(), tick)) add_event(std::move(event));
  }
  if (moments_.due(tick)) moments_.keep(run.simulation.workspace());
  return run::Flow::go_on;
}

/// Executes commands until the next tick may be computed; false if this run ends.
bool RunThread::wait_for_turn() {
  if (next_tick() == 0) return true;  // tick 0 is computed even while paused
  while (!quits_) {
    commands_.run_all();
    if (quits_ || back_to_) return false;
    if (next_tick() <= goal_) return true;
    arrive();
    if (!plays_)
      wait_until({});
    else if (is_due())
      return true;
  }
  return false;
}

/// Publishes the target tick and completes the pending call.
void RunThread::arrive() {
  if (!arrived_) return;
  hand_over();
  tell();
  std::exchange(arrived_, nullptr)->set_value();
}

void RunThread::hand_over() {
  rows_.flush();
  stored_input_ = inputs_.taken();
}

/// True if the next tick is due by the clock. Otherwise it waits until then or until a command arrives, and
/// returns false.
bool RunThread::is_due() {
  const double now = seconds_now();
  if (!std::exchange(is_paced_, true)) pace_.begin(pace_.rate(), next_tick(), now);
  const double due = pace_.due(next_tick(), now);
  if (due - now > ahead) {
    wait_until(due);
    return false;
  }
  pace_.begun(next_tick(), now);
  if (now - flushed_ < between_flushes) return true;
  flushed_ = now;
  hand_over();
  tell();
  return true;
}

void RunThread::wait_until(std::optional<double> time) {
  hand_over();
  tell();
  if (time)
    commands_.wait_until(*time);
  else
    commands_.wait();
}

void RunThread::evaluated(const run::ObservedRun& run) {
  shown_ = run.simulation.tick();
  rows_.take(run.simulation.values());
}

void RunThread::do_events(std::int64_t tick) {
  log_.each(tick, tick + 1, [&](const LiveEvent& event) { apply(event, life_->run); });
}

void RunThread::add_event(LiveEvent event) {
  apply(event, life_->run);
  log_.add(std::move(event));
}

/// Resets the run to its start, with the values that are set now.
void RunThread::start_anew() {
  const std::vector<LiveEvent> set = log_.last_of_each();
  log_ = {};
  for (LiveEvent event : set) {
    if (event.is_input()) continue;
    event.tick = before_start;
    add_event(std::move(event));
  }
  life_->run.reset();
  moments_ = Moments(ticks_between_moments(plan_));
  rows_.cut(0);
  known_ = goal_ = 0;
  shown_ = before_start;
}

/// Restores the last checkpoint before a tick; the ticks from there on are computed again.
void RunThread::go_back(std::int64_t tick) {
  const run::Workspace* moment = moments_.before(tick);
  const std::int64_t at = moment ? moment->tick : 0;
  for (const LiveEvent& event : log_.last_of_each(moment ? at : 0))
    if (!event.is_input()) apply(event, life_->run);
  if (moment)
    life_->run.restore(*moment);
  else
    life_->run.reset();
  carry_values(tick);
  moments_.cut(at);
  rows_.cut(at);
  known_ = tick + 1;
  goal_ = tick;
  shown_ = at - 1;
  fill_past();
}

/// Applies the present values from the tick after `tick` on.
void RunThread::carry_values(std::int64_t tick) {
  const std::vector<LiveEvent> now = log_.last_of_each();
  log_.cut(tick + 1);
  const std::vector<LiveEvent> then = log_.last_of_each(tick + 1);
  for (LiveEvent event : now) {
    const auto same = std::ranges::find(then, event.name, &LiveEvent::name);
    if (same != then.end() && same->text == event.text && same->values == event.values) continue;
    event.tick = tick + 1;
    log_.add(std::move(event));
  }
}

}  // namespace stepwire::live
