#pragma once

#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/state_space.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// A number of the workspace that is a row or a column of the result.
struct Place {
  std::size_t offset = 0;
  Channel channel;
  std::size_t wire = 0;  ///< For an input: offset of the signal to which it is added.
};

/// A delay of a continuous signal that an analysis removes from the diagram. Its output is cut and becomes an
/// input of the system, and its input becomes an output.
struct TakenDelay {
  std::size_t length = 0;  ///< Offset of the delay time [s].
  double shortest = 0.0;   ///< Least possible delay time [s].
  int source = -1;         ///< Index of the block that computes the delay time; -1: a constant.
};

/// A diagram with a junction in each wire that an analysis uses, and the places of its numbers. Both plans
/// have the same memory layout.
struct PreparedDiagram {
  plan::Plan plan;             ///< Plan with the diagram's own solver.
  plan::Plan slopes;           ///< Plan with a solver that leaves the derivatives of a tick in the workspace.
  std::vector<int> junctions;  ///< Indices of the junctions.
  std::vector<int> cut;        ///< Junctions that are cut.
  std::vector<Place> inputs, outputs;  ///< Numbers added at junctions; signals.
  std::vector<int> input_blocks, output_blocks;
  std::vector<TakenDelay> delays;  ///< Removed delays; their places are the last inputs and outputs.

  /// Factor from output to input of the closed loop: 1 at a cut wire, else -1.
  double feedback = -1.0;
};

/// Inserts the junctions and plans the diagram. Throws Error for unknown names.
PreparedDiagram prepare(diagram::Diagram diagram, const Request& request);

/// Returns the SI unit of a signal; empty for an unknown or dimensionless one.
std::string unit_of(const plan::Plan& plan, const diagram::SignalRef& signal);

}  // namespace stepwire::linear
