#pragma once

#include <functional>

#include "engine/analyse/tuning/evaluation.hpp"
#include "engine/analyse/tuning/search_log.hpp"

namespace stepwire::tuning {

/// Function that evaluates a point of a search. An exception ends the search.
using LookAt = std::function<const Evaluation&(const Shares&)>;

/// Computes the Jacobian of the targets by the share of each parameter, a row per target. It uses central
/// differences over a tenth of the bounds on each side, or up to the bounds. Returns std::nullopt at a point
/// without a value; `without` is the parameter that was moved.
std::optional<std::vector<std::vector<double>>> target_jacobian(const LookAt& look,
                                                                const TuneRequest& request, const Shares& at,
                                                                std::size_t& without);

/// Minimises the squared errors of the targets by the Levenberg-Marquardt method within the bounds. Its
/// derivatives are those of target_jacobian(): wide differences average out the scatter of experiments.
/// Returns true if converged.
bool search_targets(const LookAt& look, const TuneRequest& request, const Shares& from);

}  // namespace stepwire::tuning
