#pragma once

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// Infers the unit of every wire from declared ports, numbers with units and the rules of the blocks between
/// them; fills Diagram::output_dimensions and state_dimensions, and reports every wire whose ends do not
/// agree.
void infer_units(Report& report);

/// The same; returns the units that inputs take, [block][input], where known.
PortUnits infer_input_units(Report& report);

}  // namespace stepwire::diagram
