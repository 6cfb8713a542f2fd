#pragma once

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/solve/left_of.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

/// Returns a time for the limit at `time` from the left: before it where a source may jump there.
inline double left_limit(const plan::Plan& plan, double time, double length) {
  return plan.jumps ? solve::left_of(time, length) : time;
}

/// Returns the step from a tick to the next. For plans with jumps it ends just before the next tick, so that
/// the solver reads a source that jumps there as its limit from the left.
inline solve::TimeStep whole_step(const plan::Plan& plan, std::int64_t tick) {
  const double end = plan.time_of(tick + 1), length = plan.diagram.step;
  return {plan.time_of(tick), left_limit(plan, end, length), length};
}

}  // namespace stepwire::run
