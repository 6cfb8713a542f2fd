// What a run keeps and watches, checked once sizes are known.
#include <fmt/format.h>

#include "engine/diagram/parameters.hpp"
#include "engine/plan/draft.hpp"

namespace stepwire {

namespace {

void check_stop_condition(Draft& draft, const StopCondition& condition) {
  for (std::size_t i = 0; i < condition.variables.size(); ++i) {
    const SignalRef& signal = condition.variables[i];
    if (signal.block < 0 || draft.plan.slot(signal).size == 1) continue;
    draft.report.add(condition.origin, "stop_when",
                     fmt::format("'{}' has {} elements; a condition takes single numbers, so pick one with "
                                 "Select, or take the Norm",
                                 condition.expression.variables()[i], draft.plan.slot(signal).size));
  }
}

/// What is handed on in place of an output must be of its size and unit.
void check_safe_value(Draft& draft, DiagramOutput& output) {
  const std::string subject = output.name + ".safe";
  const Eigen::Index size = draft.plan.slot(output.signal).size;
  if (output.safe->size() == 1) *output.safe = Eigen::VectorXd::Constant(size, (*output.safe)[0]);
  if (output.safe->size() != size)
    draft.report.add(output.origin, subject,
                     fmt::format("has {} elements where the signal has {}", output.safe->size(), size));
  const auto dimension = draft.plan.dimension(output.signal);
  if (!dimension || !output.safe_dimension) return;
  const std::string complaint = unit_complaint(output.safe_dimension, dimension);
  if (!complaint.empty()) draft.report.add(output.origin, subject, complaint);
}

}  // namespace

void check_what_is_kept(Draft& draft) {
  if (draft.diagram().stop_when) check_stop_condition(draft, *draft.diagram().stop_when);
  for (DiagramOutput& output : draft.diagram().outputs)
    if (output.safe) check_safe_value(draft, output);
}

}  // namespace stepwire
