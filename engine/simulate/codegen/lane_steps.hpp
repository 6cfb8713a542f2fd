#pragma once

#include <string>

#include "engine/simulate/codegen/lane_places.hpp"

namespace stepwire::codegen {

/// The function of a program that steps several runs, on top of its evaluate() and advance(): it looks
/// whether numbers are finite, whether a run ends, and writes the rows that are recorded.
std::string lane_steps_text(const plan::Plan& plan, const LanePlaces& lanes);

}  // namespace stepwire::codegen
