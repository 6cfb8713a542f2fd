#pragma once

#include <cstddef>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// True for a number that the file leaves out and that has the value of its type. A gain that is
/// left out is a pure number; one in the file may have any unit.
bool is_left_out(const DiagramBlock& block, std::size_t parameter);

}  // namespace stepwire::diagram
