#include "engine/app/studio/live/run_control.hpp"

#include <algorithm>
#include <utility>

namespace stepwire::live {
namespace {

constexpr double late = 0.02, lost = 0.2, measure = 0.5;  // [s]

}  // namespace

void Pace::begin(double rate, std::int64_t tick, double now) {
  rate_ = rate;
  start_ = marked_ = now;
  first_ = marked_tick_ = tick;
  measured_ = rate;
}

void Pace::begun(std::int64_t tick, double now) {
  if (now - marked_ > measure) {
    measured_ = static_cast<double>(tick - marked_tick_) * step_ / (now - marked_);
    marked_ = now;
    marked_tick_ = tick;
  }
  if (rate_ <= 0.0) return;
  const double behind = now - due(tick, now);
  if (behind > late) ++missed_;
  if (behind <= lost) return;
  start_ = now;
  first_ = tick;
}

RunControl::RunControl(const plan::Plan& plan, const SignalList& signals, const StoreOptions& store,
                       std::uint32_t run, std::function<void()> changed)
    : plan_(plan),
      rows_(signals, plan.diagram.step, store),
      inputs_(plan),
      pace_(plan.diagram.step),
      lives_(run),
      changed_(std::move(changed)) {
  status_.run = run;
}

SetResult RunControl::set(const std::string& name, const std::string& text) {
  return commands_.ask([&] {
    LiveEvent event{next_tick(), name, text, {}, 0.0};
    event.tick = apply_now(event);
    const std::int64_t tick = std::max<std::int64_t>(event.tick, 0);
    log_.add(std::move(event));
    return SetResult{present_number(executor(), name, text), text, tick};
  });
}

RunStatus RunControl::status() const {
  const std::lock_guard lock(status_mutex_);
  return status_;
}

EventLog RunControl::log() {
  return commands_.ask([&] {
    take_rows();
    return log_;
  });
}

std::optional<double> RunControl::value(const std::string& parameter) {
  return commands_.ask([&] { return present_number(executor(), parameter, ""); });
}

void RunControl::tell() {
  {
    const std::lock_guard lock(status_mutex_);
    describe(status_);
    status_.run = lives_;
    status_.tick = std::max<std::int64_t>(shown_, 0);
    status_.time = plan_.time_of(status_.tick);
    status_.rate = status_.state == RunStatus::State::playing ? pace_.measured() : 0.0;
    status_.wanted = pace_.rate();
  }
  if (changed_) changed_();
}

void RunControl::begin_log(const std::function<void(const LiveEvent&)>& apply) {
  const std::vector<LiveEvent> set = log_.last_of_each();
  log_ = {};
  for (LiveEvent event : set) {
    if (event.is_input()) continue;
    event.tick = before_start;
    apply(event);
    log_.add(std::move(event));
  }
}

}  // namespace stepwire::live
