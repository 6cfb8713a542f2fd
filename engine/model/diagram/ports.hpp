#pragma once

#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

class Report;
class Resolver;

/// Units and shapes that files declare for ports, signals and fields of buses, in every file.
void demand_units_and_shapes(const Scope& scope, const Resolver& resolver, Report& report);
/// The outputs of the diagram itself, with what each is while the diagram does not run.
void read_outputs(const Scope& root, const Resolver& resolver, Report& report);
/// Which signals the ports of parts and the fields of buses are. What is wrong with a port that nothing uses
/// stays unsaid.
void name_ports(const Scope& scope, const Resolver& resolver, Diagram& diagram);

}  // namespace stepwire::diagram
