#pragma once

#include <string>

#include "engine/app/simulink/flat_model.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::simulink {

/// Puts a Gain of 1 before the input at which units differ, since numbers of Simulink have no units. Returns
/// false for a fault of another kind. `text` is the file of the fault.
bool free_unit(FlatModel& model, Unit& unit, const std::string& text, const yaml::Fault& fault);

}  // namespace stepwire::simulink
