#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// A stretch of the workspace whose numbers stand still while one guard is off.
struct ActivePiece {
  std::size_t first, end;
  std::ptrdiff_t active;  ///< place of what it is active by; -1: always
};

/// The numbers from `first` to `end - 1`, which are outputs, states and slopes, in pieces. A piece that is
/// too short to be worth a question counts as always active.
std::vector<ActivePiece> active_pieces(const Plan& plan, std::size_t first, std::size_t end);

}  // namespace stepwire::plan
