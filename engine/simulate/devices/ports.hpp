#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::devices {

/// One number of an input or output of a diagram.
struct Port {
  std::string name;  ///< "force", or "force.1" of several
  std::optional<unit::Dimension> dimension;
  std::optional<double> safe;  ///< of an output, SI
};

/// Return the numbers of a diagram's inputs and outputs in the order of a loop's Device.
std::vector<Port> input_ports(const plan::Plan& plan);
std::vector<Port> output_ports(const plan::Plan& plan);

}  // namespace stepwire::devices
