#pragma once

#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// Returns the places of a solver stage with numbers of its own: the signals that it computes, the time and
/// the states are in `s`.
Places stage_places(const plan::Plan& plan, Places places);

/// Returns the count of blocks that a table of a plan calls.
std::size_t count_of(const std::vector<plan::KernelCall>& batches);

}  // namespace stepwire::codegen
