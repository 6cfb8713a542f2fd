// A step that is split where blocks begin to do something else.
#include <fmt/format.h>

#include <algorithm>

#include "engine/model/plan/active.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::run {

void Executor::look_for_crossings(double* numbers) const {
  for (const plan::CrossingCall& call : plan_.crossings) {
    const std::ptrdiff_t active = plan::active_of(plan_, call.block);
    if (active >= 0 && values()[active] == 0.0)
      std::fill_n(numbers + call.first, call.count, 0.0);
    else
      plan_.diagram.blocks[call.block].type().run_crossings(memory(call.block), numbers + call.first);
  }
}

void Executor::act_at_event() {
  follow_time();
  for (int round = 0; round < solve::EventTask::rounds; ++round) {
    run(event_outputs_);
    run(event_updates_);
  }
  run(stage_);
  run(derivatives_);
  run(crossing_outputs_);
}

/// As a step without events begins.
void Executor::begin_located_step() {
  if (guards_ && solver_) guards_->keep();
  if (plan_.updates_continuous) {
    run(stage_);
    run(crossing_outputs_);
  }
  run(derivatives_);
}

void Executor::take_located_step() {
  begin_located_step();
  const plan::Layout& layout = plan_.layout;
  const solve::EventTask task{plan::Layout::time,
                              layout.states,
                              layout.derivatives,
                              layout.state_count,
                              plan_.crossing_count,
                              layout.events,
                              plan_.diagram.events.max_per_step,
                              event_scratch_.data()};
  const auto step = [&](double from, double to, double length) {
    if (solver_) step_states({from, to, length});
  };
  const auto follow = [&] {
    follow_time();
    run(crossing_outputs_);
  };
  const auto look = [&](double* numbers) { look_for_crossings(numbers); };
  const auto act = [&] { act_at_event(); };
  solve::EventLocator(task, workspace_.values.data(), step, follow, look, act)
      .advance(time(), plan_.time_of(workspace_.tick + 1), plan_.diagram.step);
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
