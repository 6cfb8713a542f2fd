#pragma once

#include <set>
#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::fmu {

/// Names of inputs, outputs and recorded signals of a diagram.
std::set<std::string> signal_names(const diagram::Diagram& diagram);

}  // namespace stepwire::fmu
