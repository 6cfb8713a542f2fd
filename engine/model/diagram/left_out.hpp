#pragma once

#include <cstddef>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// True for a number that the file omits and that equals the default of its type. An omitted gain is a pure
/// number; a gain in the file may have any unit.
bool is_left_out(const DiagramBlock& block, std::size_t parameter);

}  // namespace stepwire::diagram
