#pragma once

#include <string>
#include <vector>

#include "engine/app/fmu/description.hpp"

namespace stepwire::fmu {

/// Returns the HTML page of a unit: its description, its variables, and the conditions for bitwise equal
/// results. Parameters in `fixed` cannot be set, for the given reasons. The flag `drawn` is true if
/// diagram.svg exists beside the page.
std::string unit_page(const UnitAbout& about, const std::vector<Variable>& variables,
                      const std::vector<codegen::FixedParameter>& fixed, const std::string& no_exchange,
                      bool drawn);

}  // namespace stepwire::fmu
