#pragma once

#include <string>

#include "engine/simulate/codegen/lane_places.hpp"

namespace stepwire::codegen {

/// Returns the function that steps several runs, which uses evaluate() and advance() of the program. It
/// checks for non-finite numbers and ends of runs, and writes the recorded rows.
std::string lane_steps_text(const plan::Plan& plan, const LanePlaces& lanes);

}  // namespace stepwire::codegen
