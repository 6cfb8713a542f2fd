// What a run keeps and watches, checked once sizes are known.
#include <fmt/format.h>

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

}  // namespace

void check_what_is_kept(Draft& draft) {
  if (draft.diagram().stop_when) check_stop_condition(draft, *draft.diagram().stop_when);
}

}  // namespace stepwire
