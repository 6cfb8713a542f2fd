#include "engine/simulate/devices/ports.hpp"

#include <fmt/format.h>

namespace stepwire::devices {

namespace {

std::string element_name(const std::string& name, Eigen::Index size, Eigen::Index k) {
  return size == 1 ? name : fmt::format("{}.{}", name, k + 1);
}

}  // namespace

std::vector<Port> input_ports(const plan::Plan& plan) {
  std::vector<Port> ports;
  for (const diagram::DiagramInput& input : plan.diagram.inputs) {
    const auto block = static_cast<std::size_t>(input.block);
    const Eigen::Index size = plan.blocks[block].outputs.front().size;
    for (Eigen::Index k = 0; k < size; ++k)
      ports.push_back({element_name(input.name, size, k), plan.diagram.output_dimensions[block].front(), {}});
  }
  return ports;
}

std::vector<Port> output_ports(const plan::Plan& plan) {
  std::vector<Port> ports;
  for (const diagram::DiagramOutput& output : plan.diagram.outputs) {
    const Eigen::Index size = plan.slot(output.signal).size;
    for (Eigen::Index k = 0; k < size; ++k) {
      Port& port = ports.emplace_back();
      port.name = element_name(output.name, size, k);
      port.dimension = plan.dimension(output.signal);
      if (output.safe) port.safe = (*output.safe)[output.safe->size() == 1 ? 0 : k];
    }
  }
  return ports;
}

}  // namespace stepwire::devices
