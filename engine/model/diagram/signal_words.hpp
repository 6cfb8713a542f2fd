#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Returns the words coded by the numbers 0, 1, ... of a signal; an empty list for other signals. The output
/// `state` of a block with `states` has the names of these in the order of the file, each after its enclosing
/// states ("on.fast").
std::vector<std::string> signal_words(const Diagram& diagram, const SignalRef& signal);

}  // namespace stepwire::diagram
