#pragma once

#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// How many directions of the state inputs reach, or outputs show.
struct Rank {
  Eigen::Index rank = 0;
  /// Of [B, A B, ..., A^(n-1) B], or of its dual, largest first; of the system with balanced states, time and
  /// channels scaled so that the largest numbers are 1.
  std::vector<double> singular_values;
};

/// By the staircase form, whose rank decisions see no powers of A.
Rank controllability(const StateSpace& system);
Rank observability(const StateSpace& system);

}  // namespace stepwire::linear
