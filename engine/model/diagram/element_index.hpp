#pragma once

#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Removes the element indices from the end of a name, "rig.position.1" or "R.2.3", and returns them; the
/// whole signal without indices.
ElementIndex take_element(std::string& name);
/// Returns ".2", ".2.3", or "" for the whole signal.
std::string element_text(const ElementIndex& element);

}  // namespace stepwire::diagram
