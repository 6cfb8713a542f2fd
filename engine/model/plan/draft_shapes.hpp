#pragma once

#include <vector>

#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/units.hpp"

namespace stepwire::plan {

/// Shapes of a diagram that need not be complete, such as one that is being drawn.
struct DraftShapes {
  diagram::OutputShapes outputs;    ///< empty if they cannot be determined
  std::vector<yaml::Fault> faults;  ///< of wires whose ends have different sizes
};

/// Determines the sizes of all ports as make_plan() does. A diagram with a block that refuses its parameters
/// or connections has no shapes and no faults: its sizes are not known yet.
DraftShapes draft_shapes(diagram::Diagram diagram);

}  // namespace stepwire::plan
