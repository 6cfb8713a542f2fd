#pragma once

#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::session {

/// Looks up what `pointer` of a diagram's scene names: each must be an output of the diagram, a port of a
/// part or an output of a block. What is not goes to the faults, at its place and with the nearest name.
void check_pointer_names(const diagram::Diagram& diagram, yaml::Faults& faults);

}  // namespace stepwire::session
