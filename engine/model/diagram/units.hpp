#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// How many elements an output has; size 0: not known.
struct OutputShape {
  std::size_t size = 0, columns = 1;
};

/// Shapes of outputs, [block][output]; empty before they are known.
using OutputShapes = std::vector<std::vector<OutputShape>>;

/// Infers the unit of every wire from declared ports, numbers with units and the rules of the blocks between
/// them; fills Diagram::output_dimensions, element_dimensions and state_dimensions, and reports every wire
/// whose ends do not agree.
void infer_units(Report& report, const OutputShapes& shapes = {});

/// The same; returns the units that inputs take, [block][input], where known.
PortUnits infer_input_units(Report& report);

/// The unit of a signal or an element of one; the shapes are needed for an element of a matrix.
std::optional<unit::Dimension> dimension_of(const Diagram& diagram, const SignalRef& signal,
                                            const OutputShape& shape = {});

}  // namespace stepwire::diagram
