// Checks that a diagram is fit for a real-time loop before it begins.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulate/realtime/loop.hpp"

namespace stepwire::realtime {

std::int64_t ticks_per_period(const diagram::Diagram& diagram, double rate) {
  const double period = 1.0 / rate;
  if (const auto ticks = plan::whole_ticks(period, diagram.step)) return *ticks;
  const double near = std::max(1.0, std::round(period / diagram.step));
  throw yaml::Error(diagram.fault(
      diagram.step_origin, "step",
      fmt::format("the period of {:.9g} Hz, {:.6g} s, is no whole multiple of the step {:.6g} s; e.g. a rate "
                  "of {:.9g} Hz, or a step of {:.9g} s, would be",
                  rate, period, diagram.step, 1.0 / (near * diagram.step), period / near)));
}

void require_fit_for_loop(const plan::Plan& plan) {
  yaml::Faults faults;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks)
    if (!block.type().not_real_time.empty())
      faults.add(
          plan.diagram.fault(block.origin, block.name,
                             fmt::format("{} is not fit for a real-time loop: {}; 'stepwire run' takes it",
                                         block.type().name, block.type().not_real_time)));
  if (plan.diagram.events.locate)
    faults.add(plan.diagram.fault(plan.diagram.step_origin, "events",
                                  "a step that is split at events takes a time that nothing bounds, so a "
                                  "real-time loop takes none; leave 'events: locate' out"));
  faults.throw_if_any();
}

}  // namespace stepwire::realtime
