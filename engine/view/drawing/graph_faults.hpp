#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/error.hpp"
#include "engine/view/drawing/draw.hpp"

namespace stepwire::drawing {

/// Unknown name in the options of a drawing.
struct GraphFault {
  std::string key;   ///< key of the option: "hide"
  std::string word;  ///< the name as it was given
  yaml::Message message;
};

/// Returns all unknown names in the options of a drawing.
std::vector<GraphFault> faults_of(const DiagramView& view, const GraphOptions& options);

}  // namespace stepwire::drawing
