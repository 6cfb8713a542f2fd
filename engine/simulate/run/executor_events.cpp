// A step that is split where blocks begin to do something else.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "engine/model/plan/active.hpp"
#include "engine/simulate/run/executor.hpp"

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
  static constexpr double always = 1.0;
  if (plan_.crossing_count == 0) return;
  for (std::vector<double>* numbers : {&before_, &after_}) numbers->resize(plan_.crossing_count);
  end_states_.resize(plan_.layout.state_count);
  states_change_ = plan_.updates_continuous || guards_;
  const std::vector<bool> stands = standing_numbers();
  for (const plan::CrossingCall& call : plan_.crossings) {
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
  if (!plan_.stop_crossing) return;
  stop_margin_.emplace(plan_);
  stop_changes_ = std::ranges::any_of(stop_offsets(plan_), [&](std::size_t place) { return !stands[place]; });
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
  if (plan_.crossing_count > 0) workspace_.values[plan_.layout.events + solve::EventReport::ahead] = 0.0;
}

void Executor::follow_crossings() {
  if (!ahead_.calls.empty()) run(ahead_);
  if (!crossing_outputs_.calls.empty()) run(crossing_outputs_);
}

bool Executor::act_at_event() {
  follow_time();
  run(event_befores_);  // what a guard switches off holds what it has here
  const auto keep = [&] {
    if (!event_befores_.calls.empty()) guards_->keep();
  };
  keep();
  for (int round = 0; round < solve::EventTask::rounds; ++round) {
    run(event_outputs_);
    run(event_updates_);
    keep();
  }
  run(stage_);
  run(derivatives_);
  follow_crossings();
  return stop_margin_ && stop_margin_->stops(values());
}

void Executor::take_located_step() {
  const plan::Layout& layout = plan_.layout;
  const solve::TimeStep step{plan_.time_of(workspace_.tick), plan_.time_of(workspace_.tick + 1),
                             plan_.diagram.step};
  double* values = workspace_.values.data();
  if (plan_.updates_continuous && !crossing_starts_.calls.empty()) run(crossing_starts_);
  look_at_start();
  if (solver_) {
    run(derivatives_);
    step_states(step);
  }
  values[plan::Layout::time] = step.end;
  follow_time();
  follow_crossings();
  look_for_crossings(after_.data());
  values[layout.events + solve::EventReport::ahead] = 1.0;
  if (solve::sign_changes(before_.data(), after_.data(), plan_.crossing_count)) locate_events(step);
  knows_end_ = true;
  if (states_change_) std::copy_n(values + layout.states, layout.state_count, end_states_.data());
}

/// With the start of a step in its scratch memory.
solve::EventTask Executor::event_task() {
  const plan::Layout& layout = plan_.layout;
  const std::size_t states = layout.state_count, crossings = plan_.crossing_count;
  double* scratch = event_scratch_.data();
  std::copy_n(values() + layout.states, states, scratch);
  if (solver_)
    for (const solve::StatePiece& piece : moving_states())
      std::copy(solver_->start() + piece.first, solver_->start() + piece.end, scratch + piece.first);
  std::copy_n(before_.data(), crossings, scratch + solve::EventTask::before(states));
  std::copy_n(after_.data(), crossings, scratch + solve::EventTask::after(states, crossings));
  return {plan::Layout::time,
          layout.states,
          layout.derivatives,
          states,
          crossings,
          layout.events,
          plan_.diagram.events.max_per_step,
          scratch};
}

void Executor::locate_events(const solve::TimeStep& whole) {
  const solve::EventTask task = event_task();
  const auto step = [&](double from, double to, double length) {
    if (solver_) step_states({from, to, length});
  };
  const auto begin = [&] {
    std::fill_n(workspace_.values.data() + plan_.layout.report, plan::Layout::report_count, 0.0);
    follow_time();
    run(stage_);
    run(derivatives_);
    follow_crossings();
  };
  const auto follow = [&] {
    follow_time();
    follow_crossings();
  };
  const auto look = [&](double* numbers) { look_for_crossings(numbers); };
  const auto act = [&] { return act_at_event(); };
  solve::EventLocator(task, workspace_.values.data(), step, begin, follow, look, act)
      .advance(whole.start, whole.end, whole.length);
  look_for_crossings(after_.data());
}

EventCount Executor::event_count() const {
  if (plan_.crossing_count == 0) return {};
  const double* report = values() + plan_.layout.events;
  return {static_cast<std::int64_t>(report[solve::EventReport::events]),
          static_cast<std::int64_t>(report[solve::EventReport::most])};
}

std::optional<RunFault> Executor::too_many_events() const {
  const double* report = values() + plan_.layout.events;
  if (plan_.crossing_count == 0 || report[solve::EventReport::end] == 0.0) return std::nullopt;
  auto number = static_cast<std::size_t>(report[solve::EventReport::number]);
  for (const plan::CrossingCall& call : plan_.crossings) {
    if (number >= call.first + call.count) continue;
    const diagram::DiagramBlock& block = plan_.diagram.blocks[call.block];
    return RunFault{
        block.name, "", time(),
        plan_.diagram.fault(
            block.origin, block.name,
            fmt::format("more than {} events in the step to {:.12g} s, the last of them here; the "
                        "run ends here. Where they follow each other ever faster (a ball that comes "
                        "to rest) or a switch has no hysteresis, a threshold or a hysteresis in the "
                        "diagram helps, or 'events: {{max_per_step: ..}}'",
                        plan_.diagram.events.max_per_step, time()))};
  }
  return std::nullopt;
}

}  // namespace stepwire::run
