#pragma once

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// Determines which signals are temperatures and which are differences of temperatures, and reports
/// confusions of the two. A number in degC is a temperature, one in delta_degC a difference; one in K can be
/// either. These meanings spread along the wires. Fills Dimension::zeros of Diagram::output_dimensions, which
/// must be known. Diagrams without degC and delta_degC are skipped.
void check_temperatures(Report& report);

}  // namespace stepwire::diagram
