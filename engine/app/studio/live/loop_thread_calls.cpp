// Calls of other threads that control or observe a loop.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/app/studio/live/loop_thread.hpp"
#include "engine/app/studio/live/loop_timing.hpp"

namespace stepwire::live {

namespace {

constexpr double between_asks = 1e-4;  // [s] between checks of whether the loop has taken a value

[[noreturn]] void refuse_of_loop(const char* what) {
  throw std::runtime_error(std::string("a real-time loop ") + what);
}

}  // namespace

void LoopThread::play(double rate) {
  if (rate != 1.0) refuse_of_loop("goes in real time: its rate is 1");
  commands_.ask([&] {
    if (serves()) return;
    if (life_->loop.ended()) {
      ++lives_;
      begin_life();
    }
    begin_serving();
    tell();
  });
}

void LoopThread::pause() {
  commands_.ask([&] { stop_serving(); });
}

std::int64_t LoopThread::one_tick() {
  refuse_of_loop("takes no single ticks");
}

std::int64_t LoopThread::seek(double) {
  refuse_of_loop("does not go back");
}

void LoopThread::restart() {
  commands_.ask([&] {
    const bool goes_on = serves();
    stop_serving();
    ++lives_;
    begin_life();
    if (goes_on) begin_serving();
    tell();
  });
}

SetResult LoopThread::set(const std::string& name, const std::string& text) {
  return commands_.ask([&] {
    LiveEvent event{before_start, name, text, {}, 0.0};
    event.tick = set_in_loop(event);
    const std::int64_t tick = std::max<std::int64_t>(event.tick, 0);
    log_.add(std::move(event));
    return SetResult{present_number(life_->values.active(), name, text), text, tick};
  });
}

/// Returns the first tick with the new value.
std::int64_t LoopThread::set_in_loop(const LiveEvent& event) {
  const bool begins = shown_ < 0 && !serves();
  const auto change = [&](run::Executor& run) {
    apply(event, run);
    if (begins) run.reset();
  };
  if (serves()) {
    life_->values.offer(change);
    while (!life_->values.taken() && !life_->done)
      std::this_thread::sleep_for(std::chrono::duration<double>(between_asks));
    if (!life_->values.taken()) life_->values.at_tick();  // the loop ended before it took the value
    life_->values.follow(change);
    return *life_->values.taken();
  }
  life_->values.change_both(change);
  return begins ? before_start : life_->values.active().tick();
}

void LoopThread::input(const InputSample& sample) {
  inputs_.push(sample);
  heard(sample.client);
  commands_.push([] {});
}

void LoopThread::release(int client) {
  {
    const std::lock_guard lock(told_mutex_);
    heard_.erase(client);
  }
  inputs_.release(client);
  commands_.push([] {});
}

void LoopThread::heard(int client) {
  const std::lock_guard lock(told_mutex_);
  heard_[client] = seconds_now();
}

std::size_t LoopThread::stored(std::size_t signal) {
  return commands_.ask([&] {
    const std::size_t column = rows_.column(signal, shown_ + 1);
    select();
    return column;
  });
}

std::size_t LoopThread::stored(const query::Formula& formula) {
  return commands_.ask([&] {
    const std::size_t column = rows_.column(formula, shown_ + 1);
    select();
    return column;
  });
}

EventLog LoopThread::log() {
  return commands_.ask([&] {
    take_rows();
    return log_;
  });
}

std::optional<double> LoopThread::value(const std::string& parameter) {
  return commands_.ask([&] { return present_number(life_->values.active(), parameter, ""); });
}

RunStatus LoopThread::status() const {
  const std::lock_guard lock(told_mutex_);
  return status_;
}

void LoopThread::tell() {
  {
    const std::lock_guard lock(told_mutex_);
    const bool ended = !serves() && life_->loop.ended();
    status_.state = serves() ? RunStatus::State::playing
                    : ended  ? RunStatus::State::ended
                             : RunStatus::State::paused;
    status_.run = lives_;
    status_.tick = std::max<std::int64_t>(shown_, 0);
    status_.time = plan_.time_of(status_.tick);
    status_.rate = serves() ? pace_.measured() : 0.0;
    status_.missed = life_->loop.deadlines().missed();
    status_.input = acted_;
    if (serves()) status_.fault.clear();
    if (const auto fault = ended ? life_->loop.simulation().fault() : std::nullopt)
      status_.fault = fault->fault.text();
  }
  if (options_.changed) options_.changed();
}

std::optional<json::Json> LoopThread::timing() {
  return commands_.ask([&] {
    json::Json timing = timing_of(life_->loop, options_.settings).set("run", lives_);
    timing.set("lost", life_->tap.lost());
    const std::lock_guard lock(told_mutex_);
    return std::optional(timing.set("policy", policy_).set("refused", json::Json::list_of(refused_)));
  });
}

}  // namespace stepwire::live
