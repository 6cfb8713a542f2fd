#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// Shape of an output; size 0: unknown.
struct OutputShape {
  std::size_t size = 0, columns = 1;
};

/// Shapes of outputs, [block][output]; empty before they are known.
using OutputShapes = std::vector<std::vector<OutputShape>>;

/// Infers the unit of every wire from declared ports, numbers with units and the rules of the blocks. Fills
/// Diagram::output_dimensions, element_dimensions and state_dimensions, and reports every wire with
/// incompatible ends.
void infer_units(Report& report, const OutputShapes& shapes = {});

/// Infers units as well and returns those of inputs, [block][input], if known.
PortUnits infer_input_units(Report& report);

/// Returns the unit of a signal or one of its elements; an element of a matrix requires the shape.
std::optional<unit::Dimension> dimension_of(const Diagram& diagram, const SignalRef& signal,
                                            const OutputShape& shape = {});

/// Returns Diagram::zeros_if_kelvin of a signal; std::nullopt for states.
std::optional<double> zeros_if_kelvin(const Diagram& diagram, const SignalRef& signal);

}  // namespace stepwire::diagram
