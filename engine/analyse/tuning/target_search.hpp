#pragma once

#include <functional>

#include "engine/analyse/tuning/evaluation.hpp"
#include "engine/analyse/tuning/search_log.hpp"

namespace stepwire::tuning {

/// The evaluation at a point of a search. An exception ends the search.
using LookAt = std::function<const Evaluation&(const Shares&)>;

/// Derivatives of the targets by the share of each parameter, a row for each target. They are differences
/// over a tenth of the bounds on each side, or as far as these reach. Empty after a point without a value,
/// beside the parameter `without`.
std::optional<std::vector<std::vector<double>>> target_jacobian(const LookAt& look,
                                                                const TuneRequest& request, const Shares& at,
                                                                std::size_t& without);

/// Least squares of what the targets are off, by the Levenberg-Marquardt method within the bounds,
/// with these derivatives: differences so wide see past the scatter of experiments. Gives whether it
/// converged.
bool search_targets(const LookAt& look, const TuneRequest& request, const Shares& from);

}  // namespace stepwire::tuning
