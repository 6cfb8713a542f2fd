#pragma once

#include <string>

#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"

namespace stepwire::codegen {

/// The names of all places of the workspace, and its size.
std::string places_text(const plan::Plan& plan, const PlaceNames& names);
/// The lists that were written as tables; nothing where there are none.
std::string tables_text(const Literals& literals);

/// "double* w", in lanes "Lanes w".
std::string numbers_parameter(const LanePlaces& lanes, const std::string& name);
/// Those of a function on the workspace and the numbers of a run.
std::string workspace_parameters(const LanePlaces& lanes);

/// Copies a slope that outputs have written to the workspace.
std::string given_slope_text(const plan::Plan& plan, const LanePlaces& lanes, std::size_t place);

}  // namespace stepwire::codegen
