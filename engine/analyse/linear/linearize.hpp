#pragma once

#include <string>
#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// A number at the operating point.
struct PointValue {
  Channel channel;
  double value = 0.0;
};

/// A diagram linearised at a point of its run.
struct Linearization {
  StateSpace system;
  StateSpace error;                                 ///< Estimated errors of the matrices, in the same places.
  double time = 0.0;                                ///< Time of the point [s].
  std::vector<PointValue> states, inputs, outputs;  ///< Values at the point.
  std::vector<double> rates;       ///< Derivatives of the states there, or their change in a sample time.
  double feedback = -1.0;          ///< Sign of the closed loop: u = feedback y.
  std::string method;              ///< Sentence on the method of linearisation.
  std::vector<std::string> notes;  ///< Warnings: kinks, held values, a point that is no equilibrium.
};

/// Runs the diagram to the point and differentiates it there by differences. If no block between inputs and
/// outputs acts at ticks, the result is dx/dt. Otherwise it is the map of one base period, the least common
/// multiple of the blocks' periods. Perturbed inputs are then held for the period, and the diagram's own
/// solver steps the continuous states. Throws Error for unknown names, for a time beyond the run, and for a
/// run that ends before it.
Linearization linearize(diagram::Diagram diagram, const Request& request);

}  // namespace stepwire::linear
