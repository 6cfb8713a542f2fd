#pragma once

#include <string>

#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"

namespace stepwire::codegen {

/// Returns the names of all places of the workspace, and its size.
std::string places_text(const plan::Plan& plan, const PlaceNames& names);
/// Returns the lists that were written as tables; an empty text without any.
std::string tables_text(const Literals& literals);

/// Returns the time of a tick, with `tick` as the text of its number.
std::string time_text(const plan::Plan& plan, const std::string& tick);
/// Returns the arguments for Period::bind().
std::string period_text(const plan::Plan& plan, std::size_t block);

/// Returns "double* w", in lanes "Lanes w".
std::string numbers_parameter(const LanePlaces& lanes, const std::string& name);
/// Returns the parameters of a function on the workspace and the numbers of a run.
std::string workspace_parameters(const LanePlaces& lanes);

/// Returns the statement that copies a derivative that outputs have written to the workspace.
std::string given_slope_text(const plan::Plan& plan, const LanePlaces& lanes, std::size_t place);

}  // namespace stepwire::codegen
