// Checks of safe values and stop conditions, once sizes are known.
#include <fmt/format.h>

#include <utility>

#include "engine/model/diagram/parameters.hpp"
#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/element_slot.hpp"

namespace stepwire::plan {

namespace {

/// Refuses an element that a signal does not have.
bool check_element(Draft& draft, diagram::SignalRef signal, const std::string& name,
                   const diagram::Origin& origin, const std::string& subject) {
  const diagram::ElementIndex element = std::exchange(signal.element, {});
  const std::string missing = missing_element(element, draft.plan.slot(signal), name);
  if (!missing.empty()) draft.report.add(origin, subject, missing);
  return missing.empty();
}

void check_stop_condition(Draft& draft, const diagram::StopCondition& condition) {
  for (std::size_t i = 0; i < condition.variables.size(); ++i) {
    const diagram::SignalRef& signal = condition.variables[i];
    const std::string& name = condition.expression.variables()[i];
    if (signal.block < 0 || !check_element(draft, signal, name, condition.origin, "stop_when")) continue;
    const Eigen::Index size = draft.plan.slot(signal).size;
    if (size > 1)
      draft.report.add(condition.origin, "stop_when",
                       fmt::format("'{0}' has {1} elements; a condition takes single numbers, so name one, "
                                   "'{0}.1', or take the Norm",
                                   name, size));
  }
}

/// Checks that the safe value of an output has its size and unit.
void check_safe_value(Draft& draft, diagram::DiagramOutput& output) {
  const std::string subject = output.name + ".safe";
  const Eigen::Index size = draft.plan.slot(output.signal).size;
  if (output.safe->size() == 1) *output.safe = Eigen::VectorXd::Constant(size, (*output.safe)[0]);
  if (output.safe->size() != size)
    draft.report.add(output.origin, subject,
                     fmt::format("has {} elements where the signal has {}", output.safe->size(), size));
  const auto dimension = draft.plan.dimension(output.signal);
  if (!dimension || !output.safe_dimension) return;
  const std::string complaint = diagram::unit_complaint(output.safe_dimension, dimension);
  if (!complaint.empty()) draft.report.add(output.origin, subject, complaint);
}

}  // namespace

void check_stop_and_safe_values(Draft& draft) {
  if (draft.diagram().stop_when) check_stop_condition(draft, *draft.diagram().stop_when);
  for (const diagram::RecordRequest& request : draft.diagram().records)
    for (const diagram::RecordedSignal& signal : request.signals)
      check_element(draft, signal.signal, signal.name, signal.origin, "record");
  for (diagram::DiagramOutput& output : draft.diagram().outputs)
    if (check_element(draft, output.signal, output.name, output.origin, output.name) && output.safe)
      check_safe_value(draft, output);
}

}  // namespace stepwire::plan
