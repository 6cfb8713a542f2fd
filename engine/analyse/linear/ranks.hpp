#pragma once

#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// Number of state directions that inputs control, or that outputs observe.
struct Rank {
  Eigen::Index rank = 0;
  /// Singular values of [B, A B, ..., A^(n-1) B], or of its dual, the largest first. States are balanced;
  /// time and channels are scaled to a largest number of 1.
  std::vector<double> singular_values;
};

/// Compute the rank by the staircase form, whose rank decisions do not depend on powers of A.
Rank controllability(const StateSpace& system);
Rank observability(const StateSpace& system);

}  // namespace stepwire::linear
