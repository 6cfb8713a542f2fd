#pragma once

#include "engine/model/diagram/open.hpp"

namespace stepwire::diagram {

/// Copies each block that is fed a bus for every field of it: blocks that pass a signal of any unit and shape
/// on, as Switch, UnitDelay and ZeroOrderHold do. Their inputs of other units feed all copies.
void copy_blocks_for_buses(Scope& root, std::deque<PendingInput>& pending, std::deque<yaml::Node>& written,
                           Report& report);

}  // namespace stepwire::diagram
