#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_runs.hpp"

namespace stepwire::tuning {

/// Singular values and confidence intervals of an optimisation with targets. Parameters are scaled by the way
/// between their bounds, targets by their deviations.
struct Resolution {
  std::vector<std::vector<double>> jacobian{};  ///< Jacobian: one row per target.
  /// Singular values of the Jacobian, the largest first. A direction with a value below 1 is free: the whole
  /// way from bound to bound changes the targets by less than one deviation.
  std::vector<double> singular_values{};
  /// 95 % interval of each parameter within its bounds, SI; std::nullopt if it takes part in a free
  /// direction.
  std::vector<std::optional<std::array<double, 2>>> intervals{};
  std::vector<std::string> findings{};  ///< Parameters of each free direction, as text.
};

/// Computes these from central differences over a tenth of the bounds on each side, or up to the bounds.
Resolution resolution_of(const TuneRuns& runs, const TuneRequest& request, const Values& values,
                         unsigned threads);

}  // namespace stepwire::tuning
