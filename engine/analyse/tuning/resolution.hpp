#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_runs.hpp"

namespace stepwire::tuning {

/// Singular values and intervals of a tuning with targets. A parameter counts by its share of the way between
/// its bounds, on its scale; a target by its deviations.
struct Resolution {
  std::vector<std::vector<double>> jacobian{};  ///< a row for each target
  /// Of the Jacobian, the largest first. Along a direction of less than 1 the whole way from bound to bound
  /// moves the targets by less than a deviation: it is free.
  std::vector<double> singular_values{};
  /// 95 % of each parameter within its bounds, SI; empty of one in a free direction.
  std::vector<std::optional<std::array<double, 2>>> intervals{};
  std::vector<std::string> findings{};  ///< the parameters of each free direction
};

/// From differences over a tenth of the bounds on each side of the values, or as far as they reach.
Resolution resolution_of(const TuneRuns& runs, const TuneRequest& request, const Values& values,
                         unsigned threads);

}  // namespace stepwire::tuning
