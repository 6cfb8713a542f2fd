#pragma once

#include <map>
#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Returns all signals of a diagram by their external names: outputs of the diagram, ports of parts, outputs
/// and states of blocks.
std::map<std::string, SignalRef> named_signals(const Diagram& diagram);

}  // namespace stepwire::diagram
