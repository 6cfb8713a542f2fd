#pragma once

#include <string>
#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// A number at the point of an analysis.
struct PointValue {
  Channel channel;
  double value = 0.0;
};

/// A diagram near a point of its run, as a linear system.
struct Linearization {
  StateSpace system;
  StateSpace error;   ///< in the places of its matrices how far they may be off, as estimated
  double time = 0.0;  ///< of the point [s]
  std::vector<PointValue> states, inputs, outputs;  ///< at the point
  std::vector<double> rates;       ///< of the states there: d/dt, or the change in a sample time
  double feedback = -1.0;          ///< by which the loop is closed: u = feedback y
  std::string method;              ///< how it was found, a sentence
  std::vector<std::string> notes;  ///< what to know of it: kinks, what is held, that the point moves
};

/// Runs the diagram to the point and takes differences there. A diagram in which nothing on the ways from
/// inputs to outputs acts at ticks gives dx/dt; any other the map of one base period (the least common
/// multiple of their periods), over which what is added is held, and continuous states are stepped by the
/// diagram's own solver. Throws Error for names that are not there, a time beyond the run, and a run that
/// ends before it.
Linearization linearize(diagram::Diagram diagram, const Request& request);

}  // namespace stepwire::linear
