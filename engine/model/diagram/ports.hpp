#pragma once

#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

class Report;
class Resolver;

/// Adds the units and shapes that all files declare for ports, signals and fields of buses.
void demand_units_and_shapes(const Scope& scope, const Resolver& resolver, Report& report);
/// Reads the outputs of the diagram itself, with their safe values for the time after the run.
void read_outputs(const Scope& root, const Resolver& resolver, Report& report);
/// Lists the signals of the ports of parts and of the fields of buses. Faults of unused ports are not
/// reported.
void name_ports(const Scope& scope, const Resolver& resolver, Diagram& diagram);

}  // namespace stepwire::diagram
