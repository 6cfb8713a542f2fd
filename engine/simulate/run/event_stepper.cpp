#include "engine/simulate/run/event_stepper.hpp"

#include <algorithm>
#include <utility>

#include "engine/model/plan/tear_places.hpp"
#include "engine/simulate/run/whole_step.hpp"
#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/event_locator.hpp"
#include "engine/simulate/solve/left_of.hpp"
#include "engine/simulate/solve/watched_step.hpp"

namespace stepwire::run {

namespace {

/// Returns the count of numbers of the error control that change with each step.
std::size_t control_count(const plan::Plan& plan) {
  if (!plan.diagram.error_control) return 0;
  return solve::ControlReport::count(plan.layout.state_count) - solve::ControlReport::next;
}

std::vector<solve::Tear> tears_of(const plan::Plan& plan) {
  std::vector<solve::Tear> tears;
  for (const auto& [offset, size, residual] : plan::tear_places(plan))
    tears.push_back({offset, size, residual});
  return tears;
}

}  // namespace

/// Operations that the event locator needs for the way from one tick to the next.
struct EventStepper::BetweenTicks {
  EventStepper& of;

  void advance(double from, double to, double length) const {
    if (of.stepper_.moves()) of.stepper_.advance({from, to, length});
  }
  void advance_watched(double from, double to, double length, const solve::Stops& stops) const {
    if (of.stepper_.moves()) of.stepper_.advance({from, to, length}, &stops);
  }
  void begin() const {
    forget_fault();
    of.stepper_.follow_time();
    settle();
  }
  bool failed() const { return of.values_[of.plan_.layout.report] != solve::StepReport::fine; }
  void forget_fault() const {
    std::fill_n(of.values_ + of.plan_.layout.report, solve::StepReport::count, 0.0);
  }
  void follow() const {
    of.stepper_.follow_time();
    of.follow_crossings();
  }
  void crossings(double* numbers) const { of.looks_.find(numbers); }
  double edge() const { return of.looks_.next_edge(); }
  void before(double at) const {
    const double now = of.values_[plan::Layout::time];
    if (of.observer) of.observer->before_instant(of.values_);
    if (of.sides_) of.sides_->before(now, at);
    of.left_.update(now);
    of.stepper_.follow_time();
  }
  void begin_event() const { of.phase_.begin_event(); }
  bool round() const {
    of.phase_.find_event_outputs();
    const bool stops = of.looks_.stops();
    of.phase_.update_at_event();
    return stops;
  }
  bool after() const {
    settle();
    if (of.observer) of.observer->after_event(of.values_);
    if (of.sides_) of.sides_->after_event();
    return of.looks_.stops();
  }

 private:
  void settle() const {
    of.stepper_.find_outputs();
    of.stepper_.find_slopes();
    of.follow_crossings();
  }
};

EventStepper::EventStepper(BoundBlocks& blocks, Participants& who, Stepper& stepper, LeftSide& left,
                           DiscretePhase& phase, BothSides* sides)
    : plan_(blocks.plan()),
      values_(blocks.values()),
      stepper_(stepper),
      left_(left),
      phase_(phase),
      sides_(sides),
      ahead_(plan_.ahead, blocks, who),
      crossing_outputs_(plan_.crossing_outputs, blocks, who),
      crossing_starts_(plan_.crossing_starts, blocks, who),
      looks_(blocks),
      crossings_(2 * plan_.crossing_count),
      end_states_(plan_.layout.state_count),
      tick_states_(plan_.layout.state_count),
      tears_(tears_of(plan_)),
      loops_{tears_.data(), tears_.size()},
      guesses_(loops_.count()),
      scratch_(solve::EventTask::scratch_size(plan_.layout.state_count, plan_.crossing_count,
                                              plan_.layout.diagnostics - plan_.layout.signals,
                                              control_count(plan_), guesses_.size())),
      before_(crossings_.data()),
      after_(before_ + plan_.crossing_count),
      past_(&report(solve::EventReport::count), plan_.crossing_count),
      looks_always_(plan_.diagram.events.looks_always()),
      states_change_(plan_.updates_continuous || who.guards),
      starts_change_(states_change_ || looks_.may_change()) {}

const double* EventStepper::stopped() const {
  static constexpr double never = 0.0;
  return looks_.may_stop() ? &report(solve::EventReport::stopped) : &never;
}

bool EventStepper::is_ahead() const {
  return phase_.goes_ahead() && report(solve::EventReport::ahead) != 0.0;
}

void EventStepper::forget_ahead() {
  report(solve::EventReport::ahead) = 0.0;
}

bool EventStepper::failed() const {
  return report(solve::EventReport::end) != 0.0;
}

EventCount EventStepper::count() const {
  return {static_cast<std::int64_t>(report(solve::EventReport::events)),
          static_cast<std::int64_t>(report(solve::EventReport::most))};
}

bool EventStepper::look_at_start() {
  if (knows_end_ && !starts_change_) [[likely]] {
    std::swap(before_, after_);
    return !was_eventful_;
  }
  const plan::Layout& layout = plan_.layout;
  const double* states = values_ + layout.states;
  if (!knows_end_ ||
      (states_change_ && solve::have_changed(states, end_states_.data(), layout.state_count))) {
    looks_.find(before_);
    return false;
  }
  std::swap(before_, after_);
  if (!looks_.may_change()) return !was_eventful_;
  looks_.find_changing(before_);
  return false;
}

void EventStepper::follow_crossings() {
  if (!ahead_.empty()) ahead_.run();
  if (!crossing_outputs_.empty()) crossing_outputs_.run();
}

/// True if the step must be split. `edge` is the time of the next edge at the start of the step.
bool EventStepper::is_eventful(const solve::TimeStep& step, double edge, bool continues) const {
  const diagram::Events& events = plan_.diagram.events;
  const double end = plan_.jumps ? step.end : solve::left_of(step.end, step.length);
  return solve::is_eventful(before_, after_, past_,
                            {step.length, edge<end, true, events.looks> 0, events.looks_always(), continues});
}

bool EventStepper::is_quiet(const solve::TimeStep& step, double edge, bool continues) const {
  return continues && edge >= step.end && !looks_always_ && solve::are_within(after_, past_);
}

void EventStepper::keep_states() {
  if (plan_.updates_continuous)
    std::copy_n(values_ + plan_.layout.states, plan_.layout.state_count, tick_states_.data());
}

/// Returns false if the run ends at the tick.
bool EventStepper::settle_tick() {
  const plan::Layout& layout = plan_.layout;
  if (!solve::have_changed(values_ + layout.states, tick_states_.data(), layout.state_count)) return true;
  const solve::EventTask split = task();
  const BetweenTicks between{*this};
  return solve::EventLocator(split, values_, between).settle_tick(plan_.diagram.step);
}

void EventStepper::step(std::int64_t tick) {
  if (plan_.updates_continuous && !settle_tick()) return;
  return plan_.diagram.error_control && stepper_.moves() ? take_watched(tick) : take_whole(tick);
}

/// Takes the step of a solver with error control, with checks for events after each of the solver's own
/// steps. No outputs of the tick are computed ahead.
void EventStepper::take_watched(std::int64_t tick) {
  const solve::EventTask split = task();
  const BetweenTicks between{*this};
  solve::WatchedStep(split, values_, between)
      .advance(plan_.time_of(tick), plan_.time_of(tick + 1), plan_.diagram.step);
  forget_ahead();
}

void EventStepper::take_whole(std::int64_t tick) {
  const plan::Layout& layout = plan_.layout;
  const solve::TimeStep step = whole_step(plan_, tick);
  if (plan_.updates_continuous && !crossing_starts_.empty()) crossing_starts_.run();
  const bool continues = look_at_start();
  const double edge = looks_.next_edge();
  loops_.keep(values_, guesses_.data());
  stepper_.step(step);
  values_[plan::Layout::time] = step.end;
  stepper_.follow_time();
  follow_crossings();
  looks_.find(after_);
  report(solve::EventReport::ahead) = 1.0;
  was_eventful_ = !is_quiet(step, edge, continues) && is_eventful(step, edge, continues);
  if (was_eventful_) locate(tick);
  knows_end_ = !plan_.jumps;
  if (states_change_) std::copy_n(values_ + layout.states, layout.state_count, end_states_.data());
}

solve::EventTask EventStepper::task() {
  double* scratch = scratch_.data();
  const solve::EventTask made = task_in(scratch);
  std::copy_n(values_ + made.states, made.state_count, scratch);
  stepper_.copy_start(scratch);
  std::copy_n(before_, made.crossing_count, scratch + solve::EventTask::before(made.state_count));
  std::ranges::copy(guesses_, scratch + made.guesses());
  return made;
}

solve::EventTask EventStepper::task_in(double* scratch) const {
  const plan::Layout& layout = plan_.layout;
  const diagram::Events& events = plan_.diagram.events;
  return {plan::Layout::time,
          layout.states,
          layout.derivatives,
          layout.state_count,
          plan_.crossing_count,
          layout.signals,
          layout.diagnostics - layout.signals,
          layout.events,
          plan_.jumps,
          events.max_per_step,
          events.rounds,
          events.looks,
          events.looks_always(),
          loops_,
          layout.report + solve::ControlReport::next,
          control_count(plan_),
          scratch};
}

void EventStepper::locate(std::int64_t tick) {
  const solve::EventTask split = task();
  const BetweenTicks between{*this};
  solve::EventLocator(split, values_, between)
      .advance(plan_.time_of(tick), plan_.time_of(tick + 1), plan_.diagram.step);
  looks_.find(after_);
}

}  // namespace stepwire::run
