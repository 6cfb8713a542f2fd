#pragma once

#include <cstddef>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// True for a number that the file leaves out and that has the value of its type. Units tell it from the same
/// number in the file: a gain that is left out is a pure number.
bool is_left_out(const DiagramBlock& block, std::size_t parameter);

}  // namespace stepwire::diagram
