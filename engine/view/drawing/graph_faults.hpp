#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/error.hpp"
#include "engine/view/drawing/draw.hpp"

namespace stepwire::drawing {

/// A name in the options of a drawing that the diagram does not have.
struct GraphFault {
  std::string key;   ///< of the option: "hide"
  std::string word;  ///< as it was given
  yaml::Message message;
};

/// All that is wrong with the names in the options of a drawing.
std::vector<GraphFault> faults_of(const DiagramView& view, const GraphOptions& options);

}  // namespace stepwire::drawing
