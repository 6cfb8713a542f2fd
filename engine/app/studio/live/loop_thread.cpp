#include "engine/app/studio/live/loop_thread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stepwire::live {

namespace {

constexpr double unknown_number = std::numeric_limits<double>::quiet_NaN();
constexpr double between_hub_looks = 4e-3, hub_idle = 0.05;     // [s]
constexpr std::int64_t most_deadlines = std::int64_t{1} << 50;  // no end: 35 years at 1 MHz

realtime::LoopOptions options_of(const session::LoopSettings& settings) {
  realtime::LoopOptions options;
  options.rate = settings.rate;
  options.deadlines = most_deadlines;
  options.overrun = settings.overrun;
  return options;
}

}  // namespace

LoopThread::Life::Life(const plan::Plan& plan, const session::LoopSettings& settings,
                       realtime::LoopClock& clock)
    : values(plan),
      device(plan, clock),
      loop(
          plan,
          [&] {
            realtime::LoopOptions options = options_of(settings);
            options.pause = &pause;
            options.tap = &tap;
            options.values = &values;
            return options;
          }(),
          device, clock, nullptr) {}

LoopThread::LoopThread(const plan::Plan& plan, const SignalList& signals, Options options)
    : plan_(plan),
      options_(std::move(options)),
      clock_(options_.settings.spin),
      rows_(signals, plan.diagram.step, options_.store),
      inputs_(plan),
      pace_(plan.diagram.step),
      lives_(options_.run),
      mirror_(plan.layout.size, unknown_number),
      absent_(mirror_) {
  begin_life();
  tell();
  hub_ = std::thread([this] { main(); });
}

LoopThread::~LoopThread() {
  commands_.push([this] { quits_ = true; });
  hub_.join();
}

void LoopThread::main() {
  while (!quits_) {
    commands_.run_all();
    try {
      look();
    } catch (const std::exception& error) {  // a full disk, for example
      end_thread();
      const std::lock_guard lock(told_mutex_);
      status_.fault = error.what();
    }
    commands_.wait_until(seconds_now() + (serves() ? between_hub_looks : hub_idle));
  }
  end_thread();
}

void LoopThread::look() {
  if (serves() && life_->done) return stop_serving();
  if (!serves()) return;
  hand_inputs();
  take_rows();
  pace_.begun(shown_, seconds_now());
  tell();
}

/// Creates a loop at its start, with the values that are set.
void LoopThread::begin_life() {
  const std::vector<LiveEvent> set = log_.last_of_each();
  log_ = {};
  life_.reset();
  life_ = std::make_unique<Life>(plan_, options_.settings, clock_);
  for (LiveEvent event : set) {
    if (event.is_input()) continue;
    event.tick = before_start;
    life_->values.change_both([&](run::Executor& run) {
      apply(event, run);
      run.reset();
    });
    log_.add(std::move(event));
  }
  rows_.cut(0);
  shown_ = -1;
  seen_inputs_ = defaults_of_inputs(plan_);
  select();
}

void LoopThread::begin_serving() {
  life_->pause = life_->done = false;
  pace_.begin(1.0, shown_ + 1, seconds_now());
  life_->thread = std::thread([this] { serve(); });
}

/// Serves deadlines; runs in the loop thread.
void LoopThread::serve() {
  const realtime::RealTimeThread real_time(options_.settings.policy, options_.settings.cpu);
  {
    const std::lock_guard lock(told_mutex_);
    policy_ = realtime::RealTimeThread::policy_in_force();
    refused_ = real_time.refused();
  }
  life_->loop.serve(most_deadlines);
  life_->done = true;
}

void LoopThread::end_thread() {
  life_->pause = true;
  if (serves()) life_->thread.join();
}

void LoopThread::stop_serving() {
  if (!serves()) return;
  end_thread();
  take_rows();
  tell();
}

/// Selects the numbers that the loop passes to the hub: time, inputs, and the signals that pages display.
void LoopThread::select() {
  std::vector<std::size_t> places = rows_.places();
  places.push_back(plan::Layout::time);
  for (const diagram::DiagramInput& input : plan_.diagram.inputs) {
    const plan::SignalSlot slot = plan_.slot({input.block, 0, -1});
    for (Eigen::Index k = 0; k < slot.size; ++k) places.push_back(slot.offset + static_cast<std::size_t>(k));
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  life_->tap.select(std::move(places));
}

void LoopThread::take_rows() {
  life_->tap.take_all([this](std::int64_t tick, const std::vector<std::size_t>& places,
                             std::span<const double> values) { take_row(tick, places, values); });
  rows_.flush();
}

void LoopThread::take_row(std::int64_t tick, const std::vector<std::size_t>& places,
                          std::span<const double> values) {
  for (++shown_; shown_ < tick; ++shown_) rows_.take(absent_.data());  // rows for which the ring had no room
  for (std::size_t i = 0; i < places.size(); ++i) mirror_[places[i]] = values[i];
  rows_.take(mirror_.data());
  note_inputs(tick);
}

/// Logs the inputs of a tick that differ from those of the previous one.
void LoopThread::note_inputs(std::int64_t tick) {
  for (std::size_t i = 0; i < seen_inputs_.size(); ++i) {
    const diagram::DiagramInput& input = plan_.diagram.inputs[i];
    const double* now = mirror_.data() + plan_.slot({input.block, 0, -1}).offset;
    if (std::equal(seen_inputs_[i].begin(), seen_inputs_[i].end(), now)) continue;
    seen_inputs_[i].assign(now, now + seen_inputs_[i].size());
    log_.add({tick, input.name, "", seen_inputs_[i], sampled_[input.name]});
    acted_ = handed_;
  }
}

void LoopThread::lose_silent_pages(double now) {
  std::vector<int> silent;
  {
    const std::lock_guard lock(told_mutex_);
    for (const int writer : inputs_.writers())
      if (writer != 0 && now - heard_[writer] > options_.patience) silent.push_back(writer);
  }
  for (const int writer : silent) inputs_.release(writer);
}

/// Passes inputs of pages to the loop; an input expires if its page falls silent.
void LoopThread::hand_inputs() {
  const double now = seconds_now();
  lose_silent_pages(now);
  const auto until = clock_.now() + std::llround(1e9 * options_.patience);
  const auto& inputs = plan_.diagram.inputs;
  for (const LiveEvent& event : inputs_.take(now, 0)) {
    const auto found = std::ranges::find(inputs, event.name, &diagram::DiagramInput::name);
    life_->device.put(static_cast<std::size_t>(found - inputs.begin()), event.values, until);
    sampled_[event.name] = event.time;
    handed_ = inputs_.taken();
  }
  const std::vector<int> writers = inputs_.writers();
  for (std::size_t i = 0; i < writers.size(); ++i)
    if (writers[i] != 0) life_->device.extend(i, until);
  life_->device.give();
}

}  // namespace stepwire::live
