// What a run keeps and watches, checked once sizes are known.
#include <fmt/format.h>

#include <cmath>

#include "engine/plan/draft.hpp"

namespace stepwire {

namespace {

constexpr double most_numbers = 1e9;  // 8 GB for one recording

void check_record(Draft& draft, const RecordRequest& request) {
  const Plan& plan = draft.plan;
  double columns = 1;
  for (const RecordedSignal& signal : request.signals) columns += static_cast<double>(plan.slot(signal.signal).size);
  const double ticks = request.every ? std::round(*request.every / plan.diagram.step) : 1.0;
  const double rows = std::floor(static_cast<double>(plan.steps) / ticks) + 1.0;
  if (rows * columns > most_numbers)
    draft.report.add(request.origin, "record",
                     fmt::format("would keep {} rows of {} columns, more than memory takes; record less often, as "
                                 "{{every: 10 ms, signals: [..]}}, or stop earlier",
                                 rows, columns));
}

void check_stop_condition(Draft& draft, const StopCondition& condition) {
  for (std::size_t i = 0; i < condition.variables.size(); ++i) {
    const SignalRef& signal = condition.variables[i];
    if (signal.block < 0 || draft.plan.slot(signal).size == 1) continue;
    draft.report.add(condition.origin, "stop_when",
                     fmt::format("'{}' has {} elements; a condition takes single numbers, so pick one with Select, or take the Norm",
                                 condition.expression.variables()[i], draft.plan.slot(signal).size));
  }
}

}  // namespace

void check_what_is_kept(Draft& draft) {
  for (const RecordRequest& request : draft.diagram().records) check_record(draft, request);
  if (draft.diagram().stop_when) check_stop_condition(draft, *draft.diagram().stop_when);
}

}  // namespace stepwire
