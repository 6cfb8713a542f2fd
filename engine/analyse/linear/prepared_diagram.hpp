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
  std::size_t wire = 0;  ///< of an input the offset of the signal to which it is added
};

/// A delay of a continuous signal that an analysis takes out of its diagram: what comes out of it is cut and
/// becomes an input, and what goes into it an output.
struct TakenDelay {
  std::size_t length = 0;  ///< offset of the time by which it delays [s]
  double shortest = 0.0;   ///< that it can be [s]
  int source = -1;         ///< the block that gives the time; -1: a constant
};

/// A diagram with a junction in each wire that an analysis touches, and where its numbers lie. Both plans
/// have one layout.
struct PreparedDiagram {
  plan::Plan plan;                     ///< with the diagram's own solver
  plan::Plan slopes;                   ///< with one that leaves the derivatives of a tick behind
  std::vector<int> junctions;          ///< blocks
  std::vector<int> cut;                ///< those of them that are cut
  std::vector<Place> inputs, outputs;  ///< what is added at junctions; signals
  std::vector<int> input_blocks, output_blocks;
  std::vector<TakenDelay> delays;  ///< with the last places of inputs and outputs

  /// The factor from output to input of the closed loop: 1 at a cut wire, else -1.
  double feedback = -1.0;
};

/// Throws Error for names that are not there.
PreparedDiagram prepare(diagram::Diagram diagram, const Request& request);

/// The unit of a signal in SI; empty where none is known or it has none.
std::string unit_of(const plan::Plan& plan, const diagram::SignalRef& signal);

}  // namespace stepwire::linear
