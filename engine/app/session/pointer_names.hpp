#pragma once

#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::session {

/// Checks the names in `pointer` of a scene. Each must be an output of the diagram, a port of a part or an
/// output of a block. Unknown names become faults that suggest the nearest name.
void check_pointer_names(const diagram::Diagram& diagram, yaml::Faults& faults);

}  // namespace stepwire::session
