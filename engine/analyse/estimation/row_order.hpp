#pragma once

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::estimation {

/// True if the compared rows are a time series: by the key of the request, or if the diagram has memory.
/// Memory is a block with a state and an input. Rows of a diagram without memory are points of a function, in
/// any order.
bool in_time(const plan::Plan& plan, const FitRequest& request);

/// Returns the kind of standard errors of the intervals: that of the request, or the default for the rows'
/// order.
StandardErrors used_errors(const FitRequest& request, bool in_time);

}  // namespace stepwire::estimation
