#pragma once

#include <vector>

#include "engine/app/fmu/element.hpp"
#include "engine/app/fmu/variables.hpp"

namespace stepwire::fmu {

/// The unit of a variable as the description calls it; empty where it is not known.
std::string unit_name(const Variable& variable);

/// The type that is declared for all variables of a unit. No variable has such a name.
std::string type_name(const std::string& unit);

/// UnitDefinitions: the units of these variables by powers of SI base units, and units in which the file writes
/// parameters by their factors.
Element unit_definitions(const std::vector<Variable>& variables);

/// TypeDefinitions: a type for each unit.
Element type_definitions(const std::vector<Variable>& variables, int version);

}  // namespace stepwire::fmu
