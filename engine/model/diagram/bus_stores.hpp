#pragma once

#include "engine/model/diagram/open.hpp"

namespace stepwire::diagram {

/// Copies each block whose input is a bus, one copy for each field. This applies to blocks that pass on a
/// signal of any unit and shape, such as Switch, UnitDelay and ZeroOrderHold. Inputs of other units are
/// shared by all copies.
void copy_blocks_for_buses(Scope& root, std::deque<PendingInput>& pending, std::deque<yaml::Node>& written,
                           Report& report);

}  // namespace stepwire::diagram
