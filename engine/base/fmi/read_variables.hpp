#pragma once

#include "engine/base/fmi/description.hpp"

namespace pugi {
class xml_node;
}

namespace stepwire::fmi {

/// Reads units, types, variables and model structure into a description whose version is set. Throws
/// UnitError.
void read_variables(const pugi::xml_node& root, Description& description);

}  // namespace stepwire::fmi
