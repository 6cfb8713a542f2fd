#pragma once

#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// Places of a solver's stage that has numbers of its own: the signals that it computes anew, the time and
/// the states lie in `s`.
Places stage_places(const plan::Plan& plan, Places places);

/// How many blocks a table of a plan calls.
std::size_t count_of(const std::vector<plan::KernelCall>& batches);

}  // namespace stepwire::codegen
