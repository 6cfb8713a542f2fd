#pragma once

#include <string>
#include <vector>

#include "engine/app/fmu/description.hpp"

namespace stepwire::fmu {

/// The page of a unit, as HTML: what it is, its variables, and what keeps its bits. `fixed`: parameters that
/// cannot be set, and why; `drawn`: is there a picture diagram.svg beside it?
std::string unit_page(const UnitAbout& about, const std::vector<Variable>& variables,
                      const std::vector<codegen::FixedParameter>& fixed, const std::string& no_exchange,
                      bool drawn);

}  // namespace stepwire::fmu
