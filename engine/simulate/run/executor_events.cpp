// A step that is split where blocks begin to do something else.
#include <algorithm>
#include <cstring>
#include <limits>

#include "engine/model/plan/active.hpp"
#include "engine/simulate/run/event_fault.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/whole_step.hpp"
#include "engine/simulate/solve/left_of.hpp"

namespace stepwire::run {

/// Of the workspace, those that only the solver and the time change, and what never changes.
std::vector<bool> Executor::standing_numbers() const {
  const plan::Layout& layout = plan_.layout;
  std::vector<bool> stands(layout.size, false);
  const auto fill = [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) stands[i] = true;
  };
  fill(plan::Layout::time, plan::Layout::time + 1);
  fill(layout.constants, layout.report);
  fill(layout.states, layout.derivatives);
  for (const auto* table : {&plan_.once, &plan_.timed, &plan_.ahead})
    for (const plan::KernelCall& call : *table)
      for (const plan::PlannedBlock& block : plan_.blocks)
        if (block.memory >= call.first && block.memory < call.end)
          for (const plan::SignalSlot& slot : block.outputs)
            fill(slot.offset, slot.offset + static_cast<std::size_t>(slot.size));
  return stands;
}

void Executor::find_looks() {
  for (const std::size_t block : plan_.edges)
    edges_.push_back({plan_.diagram.blocks[block].type().run_next_edge, memory(block)});
  for (std::vector<double>* numbers : {&before_, &after_}) numbers->resize(plan_.crossing_count);
  end_states_.resize(plan_.layout.state_count);
  states_change_ = plan_.updates_continuous || guards_;
  const std::vector<bool> stands = standing_numbers();
  for (const plan::CrossingCall& call : plan_.crossings) add_look(call, stands);
  if (!plan_.stop_crossing) return;
  stop_margin_.emplace(plan_);
  stop_changes_ = std::ranges::any_of(stop_offsets(plan_), [&](std::size_t place) { return !stands[place]; });
}

void Executor::add_look(const plan::CrossingCall& call, const std::vector<bool>& stands) {
  static constexpr double always = 1.0;
  const BlockType& type = plan_.diagram.blocks[call.block].type();
  const std::ptrdiff_t active = plan::active_of(plan_, call.block);
  looks_.push_back({type.run_crossings, memory(call.block), active < 0 ? &always : values() + active,
                    call.first, call.count});
  const auto changes = [&](const CrossingSpec& spec) {
    return std::ranges::any_of(spec.inputs, [&](const std::string& input) {
      const auto& slots = plan_.blocks[call.block].inputs[static_cast<std::size_t>(type.input(input))];
      return std::ranges::any_of(slots, [&](const plan::SignalSlot& slot) { return !stands[slot.offset]; });
    });
  };
  const auto remembers = [](const StateSpec& state) { return !state.continuous; };
  if (active >= 0 || std::ranges::any_of(type.crossings, changes) ||
      std::ranges::any_of(type.states, remembers))
    changing_looks_.push_back(looks_.back());
}

void Executor::look(const std::vector<CrossingLook>& looks, double* numbers) {
  for (const CrossingLook& look : looks) {
    if (*look.active == 0.0)
      std::fill_n(numbers + look.first, look.count, 0.0);
    else
      look.run(look.block, numbers + look.first);
  }
}

void Executor::look_for_crossings(double* numbers) const {
  look(looks_, numbers);
  if (stop_margin_) numbers[*plan_.stop_crossing] = (*stop_margin_)(values());
}

void Executor::look_at_start() {
  const plan::Layout& layout = plan_.layout;
  const double* states = values() + layout.states;
  if (!knows_end_ ||
      (states_change_ && std::memcmp(states, end_states_.data(), layout.state_count * sizeof *states) != 0))
    return look_for_crossings(before_.data());
  before_.swap(after_);
  look(changing_looks_, before_.data());
  if (stop_changes_) before_[*plan_.stop_crossing] = (*stop_margin_)(values());
}

bool Executor::has_stopped() const {
  return stop_margin_ && values()[plan_.layout.events + solve::EventReport::stopped] != 0.0;
}

/// Has the step before computed what only the solver and the time change?
bool Executor::is_ahead() const {
  return !rest_.calls.empty() && !watcher_ &&
         values()[plan_.layout.events + solve::EventReport::ahead] != 0.0;
}

void Executor::forget_ahead() {
  if (plan_.splits_steps()) workspace_.values[plan_.layout.events + solve::EventReport::ahead] = 0.0;
}

void Executor::follow_crossings() {
  if (!ahead_.calls.empty()) run(ahead_);
  if (!crossing_outputs_.calls.empty()) run(crossing_outputs_);
}

double Executor::next_edge() const {
  double next = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) next = std::min(next, edge.next(edge.block));
  return next;
}

/// The way from a tick to the next with steps that are split.
struct Executor::BetweenTicks {
  Executor& of;

  void advance(double from, double to, double length) const {
    if (of.solver_) of.step_states({from, to, length});
  }
  void begin() const {
    std::fill_n(of.workspace_.values.data() + of.plan_.layout.report, solve::StepReport::count, 0.0);
    of.follow_time();
    settle();
  }
  void follow() const {
    of.follow_time();
    of.follow_crossings();
  }
  void crossings(double* numbers) const { of.look_for_crossings(numbers); }
  double edge() const { return of.next_edge(); }
  /// Keeps the present numbers of all that a guard switches off.
  void before() const {
    of.follow_time();
    of.run(of.event_befores_);
    keep();
  }
  void round() const {
    of.run(of.event_outputs_);
    of.run(of.event_updates_);
    keep();
  }
  bool after() const {
    settle();
    return of.stop_margin_ && of.stop_margin_->stops(of.values());
  }

 private:
  void keep() const {
    if (!of.event_befores_.calls.empty()) of.guards_->keep();
  }
  void settle() const {
    of.run(of.stage_);
    of.run(of.derivatives_);
    of.follow_crossings();
  }
};

namespace {

/// Tells whether a step must be gone over again, from event to event; `edge` is the next one at its start.
bool is_eventful(const plan::Plan& plan, const solve::TimeStep& step, double edge, const double* before,
                 const double* after, double* values) {
  double* const past = values + plan.layout.events + solve::EventReport::count;
  const bool looks = plan.diagram.events.looks > 0 &&
                     solve::may_cross_twice(before, after, past, plan.crossing_count, plan.loops.empty());
  const double end = plan.jumps ? step.end : solve::left_of(step.end, step.length);
  const bool eventful = edge < end || looks || solve::sign_changes(before, after, plan.crossing_count);
  if (eventful) past[0] = solve::look_closer;
  return eventful;
}

}  // namespace

void Executor::take_located_step() {
  const plan::Layout& layout = plan_.layout;
  const solve::TimeStep step = whole_step(plan_, workspace_.tick);
  double* values = workspace_.values.data();
  if (plan_.updates_continuous && !crossing_starts_.calls.empty()) run(crossing_starts_);
  look_at_start();
  const double edge = next_edge();
  if (solver_) {
    run(derivatives_);
    step_states(step);
  }
  values[plan::Layout::time] = step.end;
  follow_time();
  follow_crossings();
  look_for_crossings(after_.data());
  values[layout.events + solve::EventReport::ahead] = 1.0;
  if (is_eventful(plan_, step, edge, before_.data(), after_.data(), values)) locate_events();
  knows_end_ = !plan_.jumps;
  if (states_change_) std::copy_n(values + layout.states, layout.state_count, end_states_.data());
}

/// With the start of a step in its scratch memory.
solve::EventTask Executor::event_task() {
  const plan::Layout& layout = plan_.layout;
  const std::size_t states = layout.state_count;
  double* scratch = event_scratch_.data();
  std::copy_n(values() + layout.states, states, scratch);
  if (solver_)
    for (const solve::StatePiece& piece : moving_states())
      std::copy(solver_->start() + piece.first, solver_->start() + piece.end, scratch + piece.first);
  std::copy(before_.begin(), before_.end(), scratch + solve::EventTask::before(states));
  const diagram::Events& events = plan_.diagram.events;
  return {plan::Layout::time,
          layout.states,
          layout.derivatives,
          states,
          plan_.crossing_count,
          layout.signals,
          layout.diagnostics - layout.signals,
          layout.events,
          plan_.jumps,
          events.max_per_step,
          events.rounds,
          events.looks,
          scratch};
}

void Executor::locate_events() {
  const solve::EventTask task = event_task();
  const BetweenTicks between{*this};
  solve::EventLocator(task, workspace_.values.data(), between)
      .advance(plan_.time_of(workspace_.tick), plan_.time_of(workspace_.tick + 1), plan_.diagram.step);
  look_for_crossings(after_.data());
}

EventCount Executor::event_count() const {
  if (!plan_.splits_steps()) return {};
  const double* report = values() + plan_.layout.events;
  return {static_cast<std::int64_t>(report[solve::EventReport::events]),
          static_cast<std::int64_t>(report[solve::EventReport::most])};
}

std::optional<RunFault> Executor::event_fault() const {
  if (!plan_.splits_steps()) return std::nullopt;
  return fault_of_events(plan_, values(), time());
}

}  // namespace stepwire::run
