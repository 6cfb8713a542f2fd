#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// A range of the workspace whose numbers are constant while one guard is inactive.
struct ActivePiece {
  std::size_t first, end;
  std::ptrdiff_t active;  ///< workspace index of the guard output; -1: always active
};

/// Splits the outputs, states and derivatives in [first, end) into pieces of one guard. A piece too short to
/// be worth a check counts as always active.
std::vector<ActivePiece> active_pieces(const Plan& plan, std::size_t first, std::size_t end);

}  // namespace stepwire::plan
