#pragma once

#include <set>
#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::fmu {

/// Returns the names of inputs, outputs and recorded signals of a diagram.
std::set<std::string> signal_names(const diagram::Diagram& diagram);

}  // namespace stepwire::fmu
