#include <algorithm>

#include "engine/model/diagram/units.hpp"

namespace stepwire::diagram {

std::optional<unit::Dimension> dimension_of(const Diagram& diagram, const SignalRef& signal,
                                            const OutputShape& shape) {
  const auto block = static_cast<std::size_t>(signal.block);
  if (signal.output < 0) return diagram.state_dimensions[block][static_cast<std::size_t>(signal.state)];
  const auto whole = diagram.output_dimensions[block][static_cast<std::size_t>(signal.output)];
  if (whole || signal.element.is_whole()) return whole;
  const auto column = static_cast<std::size_t>(std::max<Eigen::Index>(signal.element.column, 1) - 1);
  const auto element =
      column * (shape.size / shape.columns) + static_cast<std::size_t>(signal.element.row - 1);
  for (const ElementDimensions& elements : diagram.element_dimensions)
    if (elements.block == signal.block && elements.output == signal.output)
      return element < elements.each.size() ? elements.each[element] : std::nullopt;
  return std::nullopt;
}

std::optional<double> zeros_if_kelvin(const Diagram& diagram, const SignalRef& signal) {
  const auto block = static_cast<std::size_t>(signal.block);
  if (signal.output < 0 || block >= diagram.zeros_if_kelvin.size()) return std::nullopt;
  return diagram.zeros_if_kelvin[block][static_cast<std::size_t>(signal.output)];
}

}  // namespace stepwire::diagram
