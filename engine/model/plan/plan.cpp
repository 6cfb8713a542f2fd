#include "engine/model/plan/plan.hpp"

#include <algorithm>

#include "engine/model/diagram/units.hpp"
#include "engine/model/plan/canonical_order.hpp"
#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/element_slot.hpp"
#include "engine/model/plan/guards.hpp"

namespace stepwire::plan {

SignalSlot Plan::slot(const diagram::SignalRef& signal) const {
  const PlannedBlock& block = blocks[static_cast<std::size_t>(signal.block)];
  return element_slot(signal.output >= 0 ? block.outputs[static_cast<std::size_t>(signal.output)]
                                         : block.states[static_cast<std::size_t>(signal.state)],
                      signal.element);
}

std::optional<unit::Dimension> Plan::dimension(const diagram::SignalRef& signal) const {
  if (signal.output < 0) return diagram::dimension_of(diagram, signal);
  const SignalSlot& whole =
      blocks[static_cast<std::size_t>(signal.block)].outputs[static_cast<std::size_t>(signal.output)];
  return diagram::dimension_of(
      diagram, signal, {static_cast<std::size_t>(whole.size), static_cast<std::size_t>(whole.columns)});
}

const std::vector<LoopCall>& Plan::loops_of(const std::vector<KernelCall>& table) const {
  static const std::vector<LoopCall> none;
  const std::pair<const std::vector<KernelCall>*, const std::vector<LoopCall>*> all[] = {
      {&once, &once_loops},
      {&timed, &timed_loops},
      {&outputs, &output_loops},
      {&stage, &stage_loops},
      {&ahead, &ahead_loops},
      {&rest, &rest_loops},
      {&crossing_outputs, &crossing_loops},
      {&crossing_starts, &crossing_start_loops},
      {&event_outputs, &event_loops},
      {&event_befores, &event_before_loops},
      {&sides, &side_loops},
      {&lefts, &left_loops}};
  for (const auto& [calls, loops] : all)
    if (calls == &table) return *loops;
  return none;
}

Plan make_plan(diagram::Diagram diagram) {
  Plan plan;
  plan.diagram = std::move(diagram);
  plan.tick_times = tick_times(plan.diagram.step);
  plan.blocks.resize(plan.diagram.blocks.size());
  Draft draft(plan);
  plan_rates(draft);
  configure_blocks(draft);
  draft.report.faults().throw_if_any();
  plan_shapes(draft);
  diagram::infer_units(draft.report, output_shapes(draft));
  draft.report.faults().throw_if_any();
  prepare_blocks(draft);
  find_timed(draft);
  draft.canonical = canonical_order(draft);
  const CallOrder order = plan_order(draft);
  draft.report.faults().throw_if_any();
  find_events(draft, order);
  plan_layout(draft, order);
  check_stop_and_safe_values(draft);
  draft.report.faults().throw_if_any();
  plan_guards(draft);
  make_schedule(draft, order);
  return plan;
}

}  // namespace stepwire::plan
