#pragma once

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::estimation {

/// True where the rows that a fit compares are a time series. They are one by the key of the request, else where
/// the diagram has memory: a block that has a state and an input. Rows of a diagram without memory are points
/// of a function, in any order.
bool in_time(const plan::Plan& plan, const FitRequest& request);

/// The standard errors of the intervals: those that the request names, else those of the rows' order.
StandardErrors used_errors(const FitRequest& request, bool in_time);

}  // namespace stepwire::estimation
