#pragma once

#include <map>
#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// All signals of a diagram by the names that may be given to them from outside: outputs of the diagram,
/// ports of parts, outputs and states of blocks.
std::map<std::string, SignalRef> named_signals(const Diagram& diagram);

}  // namespace stepwire::diagram
