#pragma once

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// Finds out which signals are temperatures and which are differences of temperatures, and reports where one
/// is written or wired in the place of the other. A number in degC is a temperature, one in delta_degC a
/// difference, and one in K can be either; from them it follows along the wires what signals are. Fills
/// Dimension::zeros of Diagram::output_dimensions, which must be known. A diagram without degC and delta_degC
/// is not searched.
void check_temperatures(Report& report);

}  // namespace stepwire::diagram
