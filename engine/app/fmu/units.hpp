#pragma once

#include <vector>

#include "engine/app/fmu/element.hpp"
#include "engine/app/fmu/variables.hpp"

namespace stepwire::fmu {

/// Returns the unit name of a variable in the description; empty if its dimension is unknown.
std::string unit_name(const Variable& variable);

/// Returns the name of the type of all variables with this unit. It contains a space, so it differs from all
/// variable names.
std::string type_name(const std::string& unit);

/// Returns UnitDefinitions: units of the variables as powers of SI base units, and the units of the file as
/// display units.
Element unit_definitions(const std::vector<Variable>& variables);

/// Returns TypeDefinitions, one type for each unit.
Element type_definitions(const std::vector<Variable>& variables, int version);

}  // namespace stepwire::fmu
