#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Words that the numbers 0, 1, ... of a signal stand for, as the output `state` of a block with `states`:
/// their names in the order of the file, each with those that hold it ("on.fast"). Empty for other signals.
std::vector<std::string> signal_words(const Diagram& diagram, const SignalRef& signal);

}  // namespace stepwire::diagram
