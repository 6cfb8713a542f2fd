#include "engine/simulate/run/faults.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/simulate/solve/event_locator.hpp"

namespace stepwire::run {

namespace {

/// Returns the block that owns a place of the workspace.
std::size_t block_with(const plan::Plan& plan, std::size_t place) {
  const auto holds = [&](const plan::SignalSlot& slot) {
    return place >= slot.offset && place < slot.offset + static_cast<std::size_t>(slot.size);
  };
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    if (std::ranges::any_of(plan.blocks[b].outputs, holds) ||
        std::ranges::any_of(plan.blocks[b].states, holds))
      return b;
  return 0;
}

std::size_t block_that_crosses(const plan::Plan& plan, std::size_t number) {
  for (const plan::CrossingCall& call : plan.crossings)
    if (number < call.first + call.count) return call.block;
  return 0;
}

std::string text_of(const diagram::Events& events, double why, double at, double tick_time) {
  if (why == solve::EventReport::unsettled)
    return fmt::format(
        "at {:.12g} s blocks keep changing each other: after {} rounds this one has changed once more, and "
        "the run "
        "ends here. A UnitDelay or a hysteresis in their circle helps, or 'events: {{rounds: ..}}'",
        at, events.rounds);
  if (why == solve::EventReport::ever_faster)
    return fmt::format(
        "at {:.12g} s its events follow each other ever faster, as those of a ball that comes to rest, and "
        "the run "
        "ends here: no step is short enough for the rest of them. A threshold below which the diagram holds "
        "what "
        "moves, or a contact with a stiffness, helps",
        at);
  return fmt::format(
      "more than {} events in the step to {:.12g} s, the last of them here; the run ends here. Where they "
      "follow each "
      "other ever faster (a ball that comes to rest) or a switch has no hysteresis, a threshold, a "
      "hysteresis or a Friction block in "
      "the diagram helps, or 'events: {{max_per_step: ..}}'",
      events.max_per_step, tick_time);
}

}  // namespace

std::optional<RunFault> fault_of_events(const plan::Plan& plan, const double* values, double tick_time) {
  const double* report = values + plan.layout.events;
  const double why = report[solve::EventReport::end], at = values[plan::Layout::time];
  if (why == 0.0) return std::nullopt;
  const auto number = static_cast<std::size_t>(report[solve::EventReport::number]);
  const bool unsettled = why == solve::EventReport::unsettled;
  const diagram::DiagramBlock& block =
      plan.diagram.blocks[unsettled ? block_with(plan, number) : block_that_crosses(plan, number)];
  const double when = why == solve::EventReport::too_many ? tick_time : at;
  return RunFault{
      block.name, "", when,
      plan.diagram.fault(block.origin, block.name, text_of(plan.diagram.events, why, at, tick_time))};
}

}  // namespace stepwire::run
