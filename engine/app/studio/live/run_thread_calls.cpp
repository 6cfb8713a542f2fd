// Calls of other threads that control a run.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/app/studio/live/past.hpp"
#include "engine/app/studio/live/run_thread.hpp"

namespace stepwire::live {

/// Executes an action in the run's thread and publishes the new status.
template <class Act>
void RunThread::act(const Act& act) {
  commands_.ask([&] {
    act();
    tell();
  });
}

void RunThread::go_to(std::int64_t tick) {
  back_to_ = tick;
  ended_ = false;
}

void RunThread::play(double rate) {
  act([&] {
    if (ended_) go_to(before_start);
    pace_.begin(rate, next_tick(), seconds_now());
    is_paced_ = false;
    plays_ = true;
  });
}

void RunThread::pause() {
  act([&] {
    plays_ = false;
    goal_ = std::min(goal_, shown_);
  });
}

std::int64_t RunThread::one_tick() {
  constexpr std::chrono::seconds patience{1};  // limit for very slow ticks
  const auto arrived = std::make_shared<std::promise<void>>();
  const std::int64_t tick = commands_.ask([&] {
    plays_ = false;
    goal_ = ended_ ? shown_ : next_tick();
    arrived_ = arrived;
    return goal_;
  });
  arrived->get_future().wait_for(patience);
  return tick;
}

void RunThread::restart() {
  act([&] { go_to(before_start); });
}

std::int64_t RunThread::seek(double time) {
  const double ticks =
      std::clamp(std::round(time / plan_.diagram.step), 0.0, static_cast<double>(plan_.steps));
  const auto tick = static_cast<std::int64_t>(ticks);
  act([&] {
    if (tick <= shown_)
      go_to(tick);
    else
      goal_ = tick;
    is_paced_ = false;
  });
  return tick;
}

SetResult RunThread::set(const std::string& name, const std::string& text) {
  return commands_.ask([&] {
    add_event({next_tick(), name, text, {}, 0.0});
    code_.was_set(name);
    return SetResult{present_number(life_->run, name, text), text, next_tick()};
  });
}

void RunThread::input(const InputSample& sample) {
  inputs_.push(sample);
}

void RunThread::release(int client) {
  inputs_.release(client);
}

std::size_t RunThread::stored(std::size_t signal) {
  return commands_.ask([&] {
    const std::size_t column = rows_.column(signal, next_tick());
    fill_past();
    return column;
  });
}

std::size_t RunThread::stored(const query::Formula& formula) {
  return commands_.ask([&] {
    const std::size_t column = rows_.column(formula, next_tick());
    fill_past();
    return column;
  });
}

/// Starts the computation of samples before the first tick of columns that were selected after the start.
void RunThread::fill_past() {
  past_interrupt_ = true;
  if (past_.joinable()) past_.join();
  std::vector<RowGathering::Incomplete> columns = rows_.incomplete();
  if (columns.empty()) return;
  past_interrupt_ = false;
  past_ = std::thread([this, life = lives_, log = log_, columns = std::move(columns)] {
    std::vector<std::vector<double>> samples;
    try {
      samples = past_of(plan_, log, columns, past_interrupt_);
    } catch (const std::exception&) {  // the columns remain incomplete; the page shows their begin
    }
    if (!samples.empty()) commands_.push([=, this] { put_past(life, columns, samples); });
  });
}

void RunThread::put_past(std::uint32_t life, const std::vector<RowGathering::Incomplete>& columns,
                         const std::vector<std::vector<double>>& samples) {
  if (life != lives_) return;
  rows_.flush();
  for (std::size_t i = 0; i < columns.size(); ++i) rows_.put_past(columns[i].index, samples[i]);
  tell();
}

EventLog RunThread::log() {
  return commands_.ask([&] { return log_; });
}

std::optional<double> RunThread::value(const std::string& parameter) {
  return commands_.ask([&] { return present_number(life_->run, parameter, ""); });
}

RunStatus RunThread::status() const {
  const std::lock_guard lock(status_mutex_);
  return status_;
}

void RunThread::tell() {
  {
    const std::lock_guard lock(status_mutex_);
    status_.state = ended_   ? RunStatus::State::ended
                    : plays_ ? RunStatus::State::playing
                             : RunStatus::State::paused;
    status_.run = lives_;
    status_.tick = std::max<std::int64_t>(shown_, 0);
    status_.time = plan_.time_of(status_.tick);
    status_.rate = plays_ ? pace_.measured() : 0.0;
    status_.wanted = pace_.rate();
    status_.missed = pace_.missed();
    status_.compiled = life_ && life_->run.compiled();
    status_.input = stored_input_;
    status_.fault = fault_;
  }
  if (options_.changed) options_.changed();
}

}  // namespace stepwire::live
