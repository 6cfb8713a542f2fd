#pragma once

#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Takes the numbers of an element off the end of a name, "rig.position.1" or "R.2.3"; the whole signal where
/// there are none.
ElementIndex take_element(std::string& name);
/// ".2", ".2.3", or nothing for the whole signal.
std::string element_text(const ElementIndex& element);

}  // namespace stepwire::diagram
